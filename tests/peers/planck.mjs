// Planck, a JavaScript port of Box2D 2.4. Parameters: substeps (1), and iterations (8) of velocities; 3 of positions.
import * as planck from 'planck';

export const packages = { planck: 'planck' };

const linkCategory = 2;

export async function make(plan, parameters) {
  const { substeps = 1, iterations = 8 } = parameters;
  const world = new planck.World({ gravity: { x: plan.gravity[0], y: plan.gravity[1] }, allowSleep: false });
  const vec = ([x, y]) => ({ x, y });
  const bodies = plan.bodies.map((from) => {
    const body = world.createBody({
      type: from.dynamic ? 'dynamic' : 'static', position: vec(from.position), angle: from.angle,
    });
    const add = (shape, filter = {}) => body.createFixture({ shape, friction: from.friction, density: 1, ...filter });
    if (from.halfLength > 0) {
      // As in game/lab/joint_chain.h: half the thickness is the box's, half its skin's.
      const box = new planck.BoxShape(from.halfLength, 0.5 * from.radius);
      box.m_radius = 0.5 * from.radius;
      add(box, { filterCategoryBits: linkCategory, filterMaskBits: 0xffff & ~linkCategory });
    } else if (from.radius > 0) {
      add(new planck.CircleShape(from.radius));
    }
    const [x, y] = from.position;
    for (const [a, b] of from.edges) {
      add(new planck.EdgeShape({ x: a[0] - x, y: a[1] - y }, { x: b[0] - x, y: b[1] - y }));
    }
    if (from.dynamic) body.setMassData({ mass: from.mass, center: { x: 0, y: 0 }, I: from.inertia });
    return body;
  });
  for (const hinge of plan.hinges) {
    world.createJoint(new planck.RevoluteJoint({}, bodies[hinge.a], bodies[hinge.b], vec(hinge.place)));
  }
  return {
    step() {
      for (let k = 0; k < substeps; ++k) world.step(plan.dt / substeps, iterations, 3);
    },
    pose(k, out) {
      const place = bodies[k].getPosition();
      [out[0], out[1], out[2]] = [place.x, place.y, bodies[k].getAngle()];
    },
    slowDown(share) {
      for (const body of bodies) {
        const v = body.getLinearVelocity();
        body.setLinearVelocity({ x: share * v.x, y: share * v.y });
        body.setAngularVelocity(share * body.getAngularVelocity());
      }
    },
  };
}
