// run_plan.mjs ENGINE PLAN RECORDING [parameter=value …]: runs a plan (tests/peers/plan.h) with an engine from npm.
// Writes the time of each tick and the positions after it (tests/peers/recording.h).
// run_plan.mjs ENGINE --version
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';

// An engine's module exports packages: { name: npm package } and make(plan, parameters, name), which returns an object with
//   step()             takes a tick
//   pose(body, out)    writes x, y and angle of a body of the plan into out
//   slowDown(share)    multiplies all velocities
//   points(cord, out)  optional: writes a cord's points into out, if cords are not chains of links
const modules = {
  box2d3: './box2d3.mjs',
  rapier: './rapier.mjs',
  rapier_simd: './rapier.mjs',
  planck: './planck.mjs',
  matter: './matter.mjs',
};

const [name, planPath, recordingPath, ...settings] = process.argv.slice(2);
if (!modules[name]) {
  console.error(`no engine is named '${name}'; accepted are ${Object.keys(modules).join(', ')}`);
  process.exit(2);
}
const engine = await import(modules[name]);
if (planPath === '--version') {
  // Not every package allows an import of its package.json.
  const require = createRequire(import.meta.url);
  const folders = require.resolve.paths(engine.packages[name]);
  for (const folder of folders) {
    try {
      console.log(JSON.parse(readFileSync(`${folder}/${engine.packages[name]}/package.json`)).version);
      process.exit(0);
    } catch { /* not in this folder */ }
  }
  process.exit(1);
}

const plan = JSON.parse(readFileSync(planPath));
const parameters = Object.fromEntries(settings.map((text) => {
  const [key, value] = text.split('=');
  return [key, Number(value)];
}));

const columns = 1 + 2 * (plan.cords.reduce((sum, cord) => sum + cord.positions.length, 0) + plan.movingBodies.length);

/// Writes the points of each cord, or the front end of its first link and the rear ends of all links.
function record(world, row) {
  let at = 1;
  const pose = [0, 0, 0];
  const put = (x, y) => {
    row[at++] = x;
    row[at++] = y;
  };
  for (const [c, cord] of plan.cords.entries()) {
    if (world.points) {
      at += world.points(c, row.subarray(at));
      continue;
    }
    const end = (link, side) => {
      world.pose(link, pose);
      const half = side * plan.bodies[link].halfLength;
      put(pose[0] + half * Math.cos(pose[2]), pose[1] + half * Math.sin(pose[2]));
    };
    end(cord.links[0], -1);
    for (const link of cord.links) end(link, 1);
  }
  for (const movingBody of plan.movingBodies) {
    world.pose(movingBody, pose);
    put(pose[0], pose[1]);
  }
}

async function run() {
  const world = await engine.make(plan, parameters, name);
  for (let tick = 0; tick < plan.settlingTicks; ++tick) {
    world.step();
    world.slowDown(0.9);
  }
  const frames = [];
  for (let tick = 0; tick < plan.ticks; ++tick) {
    const row = new Float64Array(columns);
    const start = process.hrtime.bigint();
    world.step();
    row[0] = Number(process.hrtime.bigint() - start) / 1000;
    record(world, row);
    frames.push(row);
    if (!row.subarray(1).every((value) => Math.abs(value) < 1e4)) break;
  }
  return frames;
}

// The first run warms up the compiler; the second is recorded, unless it would take too long.
const began = process.hrtime.bigint();
let frames = await run();
if (Number(process.hrtime.bigint() - began) < 5e9) frames = await run();
writeFileSync(recordingPath, Buffer.concat(frames.map((row) => Buffer.from(row.buffer))));
process.exit(0);
