// Rapier, compiled to WebAssembly: `rapier`, and the older `rapier_simd` without soft bodies. Parameters: substeps
// (1), iterations (4) of the solver, and one of
//   joints=1  impulse joints between links
//   joints=2  multibody joints in reduced coordinates, in which a chain cannot stretch; an impulse joint closes a
//             loop
//   joints=0  soft bodies: a rope's points are particles, a ribbon's cells are triangles of `young` Pa
// `hertz` is the stiffness of the edges of a soft rope (1000).
export const packages = { rapier: '@dimforge/rapier2d-compat', rapier_simd: '@dimforge/rapier2d-simd-compat' };

const linkGroups = 0x0002_fffd; // member of group 2; collides with all others
const otherGroups = 0x0001_ffff;

const vec = ([x, y]) => ({ x, y });

function addBodies(RAPIER, world, plan, withLinks) {
  return plan.bodies.map((from) => {
    if (from.halfLength > 0 && !withLinks) return null;
    const desc = from.dynamic ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed();
    // Rotate the shape, not the body: a multibody joint assumes that both bodies start with the same angle.
    desc.setTranslation(...from.position).setCanSleep(false);
    if (from.dynamic) desc.setAdditionalMassProperties(from.mass, { x: 0, y: 0 }, from.inertia);
    const body = world.createRigidBody(desc);
    const add = (shape, groups) => world.createCollider(
      shape.setDensity(0).setFriction(from.friction).setCollisionGroups(groups), body);
    if (from.halfLength > 0) {
      // Rapier's capsules are vertical.
      add(RAPIER.ColliderDesc.capsule(from.halfLength, from.radius).setRotation(from.angle - 0.5 * Math.PI), linkGroups);
    } else if (from.radius > 0) {
      add(RAPIER.ColliderDesc.ball(from.radius), otherGroups);
    }
    const [x, y] = from.position;
    for (const [a, b] of from.edges) {
      add(RAPIER.ColliderDesc.segment({ x: a[0] - x, y: a[1] - y }, { x: b[0] - x, y: b[1] - y }), otherGroups);
    }
    return body;
  });
}

function addHinges(RAPIER, world, plan, bodies, asMultibody) {
  const join = (hinge, a, b, multibody, bodyA = bodies[a]) => {
    const anchor = (k) => {
      const [x, y] = plan.bodies[k].position;
      return { x: hinge.place[0] - x, y: hinge.place[1] - y };
    };
    const joint = RAPIER.JointData.revolute(anchor(a), anchor(b));
    const made = multibody
      ? world.createMultibodyJoint(joint, bodyA, bodies[b], true)
      : world.createImpulseJoint(joint, bodyA, bodies[b], true);
    made.setContactsEnabled(false);
  };
  if (!asMultibody) {
    for (const hinge of plan.hinges) join(hinge, hinge.a, hinge.b, false);
    return;
  }
  // A multibody is a tree; create it from its root.
  const hingesOf = plan.bodies.map(() => []);
  for (const hinge of plan.hinges) {
    hingesOf[hinge.a].push(hinge);
    hingesOf[hinge.b].push(hinge);
  }
  const reached = new Set();
  const done = new Set();
  const grow = (first) => {
    reached.add(first);
    for (const queue = [first]; queue.length > 0;) {
      const parent = queue.shift();
      for (const hinge of hingesOf[parent]) {
        if (done.has(hinge) || !plan.bodies[hinge.a].dynamic) continue;
        done.add(hinge);
        const child = hinge.a === parent ? hinge.b : hinge.a;
        join(hinge, parent, child, true);
        reached.add(child);
        queue.push(child);
      }
    }
  };
  // A separate body fixes each pin; otherwise all cords at one body would form one multibody. A cord's second pin
  // closes a loop.
  for (const pin of plan.hinges.filter(({ a }) => !plan.bodies[a].dynamic)) {
    const fixed = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(...plan.bodies[pin.a].position));
    done.add(pin);
    join(pin, pin.a, pin.b, !reached.has(pin.b), fixed);
    if (!reached.has(pin.b)) grow(pin.b);
  }
  for (const hinge of plan.hinges) {
    if (!done.has(hinge)) grow(hinge.a);
  }
}

/// Returns a cord's edges, with points in rows across, and the triangles of a ribbon.
function lattice(cord) {
  const at = (i, j) => i * cord.rows + j;
  const edges = [];
  const cells = [];
  for (let i = 0; i < cord.points; ++i) {
    for (let j = 0; j < cord.rows; ++j) {
      if (i + 1 < cord.points) edges.push(at(i, j), at(i + 1, j));
      if (j + 1 < cord.rows) edges.push(at(i, j), at(i, j + 1));
      if (i + 1 < cord.points && j + 1 < cord.rows) {
        cells.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return { edges, cells };
}

/// Returns the boundary: counter-clockwise around a ribbon, along a rope.
function surface(cord) {
  const along = [...Array(cord.points).keys()];
  if (cord.rows === 1) return along.slice(1).flatMap((i) => [i - 1, i]);
  const around = [...along.map((i) => i * cord.rows), ...along.reverse().map((i) => i * cord.rows + cord.rows - 1)];
  return around.flatMap((p, k) => [p, around[(k + 1) % around.length]]);
}

function addSoftCord(RAPIER, world, cord, bodies, parameters) {
  const { hertz = 1000, young = 1e5 } = parameters;
  const { edges, cells } = lattice(cord);
  const desc = new RAPIER.SoftBodyDesc(new Float32Array(cord.positions.flat()));
  desc.setSurface(surface(cord));
  if (cord.rows === 1) {
    // Half of a link's mass is at each of its ends.
    const share = cord.mass / (cord.points - 1);
    desc.setEdges(edges).setSoftness(hertz, 1).setMasses(cord.positions.map((_, p) => (
      p === 0 || p === cord.points - 1 ? 0.5 * share : share)));
  } else {
    const material = new RAPIER.SoftBodyMaterial();
    material.youngModulus = young;
    material.poissonRatio = 0.3;
    desc.setMaterial(material).setCells(cells).setMass(cord.mass);
    desc.setCellModel(RAPIER.SoftBodyCellModel.Corotational).setSolver(RAPIER.SoftBodySolver.Fem);
  }
  desc.setPinnedParticles(cord.pins).setCanSleep(false).setSelfContacts(cord.selfContact).setParticleRadius(cord.radius);
  const groups = cord.cordContact ? otherGroups : linkGroups;
  desc.setSurfaceCollider(RAPIER.ColliderDesc.ball(1).setFriction(cord.friction).setCollisionGroups(groups));
  const soft = world.createSoftBody(desc);
  for (const { point, body } of cord.held) soft.attachParticle(point, bodies[body]);
  return soft;
}

export async function make(plan, parameters, name) {
  const RAPIER = await import(packages[name]);
  await RAPIER.init();
  const { substeps = 1, iterations = 4, joints = 1 } = parameters;
  const world = new RAPIER.World(vec(plan.gravity));
  world.timestep = plan.dt / substeps;
  world.numSolverIterations = iterations;
  const bodies = addBodies(RAPIER, world, plan, joints !== 0);
  if (joints !== 0) addHinges(RAPIER, world, plan, bodies, joints === 2);
  const softs = joints === 0 ? plan.cords.map((cord) => addSoftCord(RAPIER, world, cord, bodies, parameters)) : [];
  const made = {
    step() {
      for (let k = 0; k < substeps; ++k) world.step();
    },
    pose(k, out) {
      const place = bodies[k].translation();
      [out[0], out[1], out[2]] = [place.x, place.y, plan.bodies[k].angle + bodies[k].rotation()];
    },
    slowDown(share) {
      for (const body of bodies) {
        if (body === null || !body.isDynamic()) continue;
        const v = body.linvel();
        body.setLinvel({ x: share * v.x, y: share * v.y }, true);
        body.setAngvel(share * body.angvel(), true);
      }
      for (const soft of softs) {
        const v = soft.particleVelocities();
        for (let p = 0; p < soft.numParticles(); ++p) {
          soft.setParticleVelocity(p, { x: share * v[2 * p], y: share * v[2 * p + 1] });
        }
      }
    },
  };
  if (joints === 0) {
    made.points = (c, out) => {
      const places = softs[c].particlePositions();
      out.set(places);
      return places.length;
    };
  }
  return made;
}
