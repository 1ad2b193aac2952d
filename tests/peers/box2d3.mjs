// Box2D 3, compiled to WebAssembly with SIMD, one thread. Parameters: substeps (4), which are also its iterations.
import Box2DFactory from 'box2d3-wasm';

export const packages = { box2d3: 'box2d3-wasm' };

const linkCategory = 2;
let loaded;

export async function make(plan, parameters) {
  const { substeps = 4 } = parameters;
  loaded ??= await Box2DFactory();
  const b2 = loaded;
  const vec = ([x, y]) => new b2.b2Vec2(x, y);
  const worldDef = b2.b2DefaultWorldDef();
  worldDef.gravity = vec(plan.gravity);
  worldDef.enableSleep = false;
  worldDef.workerCount = 0;
  const world = b2.b2CreateWorld(worldDef);
  const bodies = plan.bodies.map((from) => {
    const def = b2.b2DefaultBodyDef();
    def.type = from.dynamic ? b2.b2BodyType.b2_dynamicBody : b2.b2BodyType.b2_staticBody;
    def.position = vec(from.position);
    def.rotation = b2.b2MakeRot(from.angle);
    const body = b2.b2CreateBody(world, def);
    const shapeDef = b2.b2DefaultShapeDef();
    const material = shapeDef.material;
    material.friction = from.friction;
    shapeDef.material = material;
    shapeDef.density = from.dynamic ? 1 : 0;
    if (from.halfLength > 0) {
      const filter = shapeDef.filter;
      filter.setCategoryBits64(String(linkCategory));
      filter.setMaskBits64(String(0xffff & ~linkCategory));
      shapeDef.filter = filter;
      const capsule = new b2.b2Capsule();
      capsule.center1 = vec([-from.halfLength, 0]);
      capsule.center2 = vec([from.halfLength, 0]);
      capsule.radius = from.radius;
      b2.b2CreateCapsuleShape(body, shapeDef, capsule);
    } else if (from.radius > 0) {
      const circle = new b2.b2Circle();
      circle.center = vec([0, 0]);
      circle.radius = from.radius;
      b2.b2CreateCircleShape(body, shapeDef, circle);
    }
    const [x, y] = from.position;
    for (const [a, b] of from.edges) {
      const segment = new b2.b2Segment();
      segment.point1 = vec([a[0] - x, a[1] - y]);
      segment.point2 = vec([b[0] - x, b[1] - y]);
      b2.b2CreateSegmentShape(body, shapeDef, segment);
    }
    if (from.dynamic) {
      const data = new b2.b2MassData();
      data.mass = from.mass;
      data.center = vec([0, 0]);
      data.rotationalInertia = from.inertia;
      b2.b2Body_SetMassData(body, data);
    }
    return body;
  });
  for (const hinge of plan.hinges) {
    const def = b2.b2DefaultRevoluteJointDef();
    const { base } = def;
    const frame = (k) => {
      const { position, angle } = plan.bodies[k];
      const [dx, dy] = [hinge.place[0] - position[0], hinge.place[1] - position[1]];
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const transform = new b2.b2Transform();
      transform.p = vec([c * dx + s * dy, c * dy - s * dx]);
      transform.q = b2.b2MakeRot(-angle);
      return transform;
    };
    base.bodyIdA = bodies[hinge.a];
    base.bodyIdB = bodies[hinge.b];
    base.localFrameA = frame(hinge.a);
    base.localFrameB = frame(hinge.b);
    def.base = base;
    b2.b2CreateRevoluteJoint(world, def);
  }
  return {
    step() {
      b2.b2World_Step(world, plan.dt, substeps);
    },
    pose(k, out) {
      const place = b2.b2Body_GetPosition(bodies[k]);
      const turn = b2.b2Body_GetRotation(bodies[k]);
      [out[0], out[1], out[2]] = [place.x, place.y, Math.atan2(turn.s, turn.c)];
      place.delete();
      turn.delete();
    },
    slowDown(share) {
      for (const [k, body] of bodies.entries()) {
        if (!plan.bodies[k].dynamic) continue;
        const v = b2.b2Body_GetLinearVelocity(body);
        const slower = vec([share * v.x, share * v.y]);
        b2.b2Body_SetLinearVelocity(body, slower);
        b2.b2Body_SetAngularVelocity(body, share * b2.b2Body_GetAngularVelocity(body));
        v.delete();
        slower.delete();
      }
    },
  };
}
