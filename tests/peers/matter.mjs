// Matter.js: bodies connected by constraints. Parameters: substeps (1), and iterations (6) of positions and of
// constraints.
import Matter from 'matter-js';

export const packages = { matter: 'matter-js' };

const { Bodies, Body, Composite, Constraint, Engine } = Matter;

const pixels = 100; // per metre; its tolerances are in pixels
const linkCategory = 2;
const edgeThickness = 0.5; // m, behind an edge

export async function make(plan, parameters) {
  const { substeps = 1, iterations = 6 } = parameters;
  const engine = Engine.create({
    gravity: { x: 0, y: 1, scale: plan.gravity[1] * pixels * 1e-6 },
    positionIterations: iterations, velocityIterations: iterations, constraintIterations: iterations,
  });
  const parts = [];
  const bodies = plan.bodies.map((from) => {
    const [x, y] = from.position.map((value) => value * pixels);
    const options = {
      isStatic: !from.dynamic, friction: from.friction, frictionStatic: 0, frictionAir: 0, restitution: 0, slop: 0.5,
    };
    let body;
    if (from.halfLength > 0) {
      options.collisionFilter = { group: 0, category: linkCategory, mask: ~linkCategory };
      body = Bodies.rectangle(x, y, 2 * from.halfLength * pixels, 2 * from.radius * pixels, options);
    } else if (from.radius > 0) {
      body = Bodies.circle(x, y, from.radius * pixels, options);
    } else {
      options.collisionFilter = { group: 0, category: 0, mask: 0 }; // an anchor or a load, without collision
      body = Bodies.rectangle(x, y, 1, 1, options);
    }
    if (from.dynamic) {
      Body.setMass(body, from.mass);
      Body.setInertia(body, from.inertia * pixels * pixels);
    }
    Body.setAngle(body, from.angle);
    parts.push(body);
    // The interior of an edge is on its left.
    for (const [a, b] of from.edges) {
      const along = [b[0] - a[0], b[1] - a[1]];
      const length = Math.hypot(...along);
      const out = [along[1] / length, -along[0] / length];
      const middle = [0, 1].map((k) => (0.5 * (a[k] + b[k]) + 0.5 * edgeThickness * out[k]) * pixels);
      parts.push(Bodies.rectangle(middle[0], middle[1], length * pixels, edgeThickness * pixels, {
        isStatic: true, friction: from.friction, angle: Math.atan2(along[1], along[0]),
      }));
    }
    return body;
  });
  Composite.add(engine.world, parts);
  for (const hinge of plan.hinges) {
    const local = (body) => ({
      x: hinge.place[0] * pixels - body.position.x, y: hinge.place[1] * pixels - body.position.y,
    });
    const [bodyA, bodyB] = [bodies[hinge.a], bodies[hinge.b]];
    Composite.add(engine.world, Constraint.create({
      bodyA, bodyB, pointA: local(bodyA), pointB: local(bodyB), length: 0, stiffness: 1,
    }));
  }
  return {
    step() {
      for (let k = 0; k < substeps; ++k) Engine.update(engine, 1000 * plan.dt / substeps);
    },
    pose(k, out) {
      const { position, angle } = bodies[k];
      [out[0], out[1], out[2]] = [position.x / pixels, position.y / pixels, angle];
    },
    slowDown(share) {
      for (const body of bodies) {
        if (body.isStatic) continue;
        const v = Body.getVelocity(body);
        Body.setVelocity(body, { x: share * v.x, y: share * v.y });
        Body.setAngularVelocity(body, share * Body.getAngularVelocity(body));
      }
    },
  };
}
