// Keys, mouse and fingers play in the page; it pauses, sounds, and keeps what is to be kept.
'use strict';
const assert = require('node:assert');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const {Browser, wait} = require('./browser.js');
const clock = require('./clock.js');
const {inputsOf, keysOf} = require('./recorded_keys.js');

const folder = '/user/config/ropeswing';
const settings = `filesIn("${folder}").map(n => Module.FS.readFile("${folder}/" + n, {encoding: "utf8"})).join("")`;
const sound = '(Module.SDL2?.audioContext?.state ?? "none")';
const has = (inputs, bit) => inputs.some(buttons => buttons >> bit & 1);

module.exports = {
  async 'keys and mouse run, throw and pause'(visit, browser) {
    await visit.open('#level=line_and_knife');
    await wait(500);
    const before = await visit.picture('before_keys');
    await browser.down('KeyD');
    await wait(700);
    await browser.up('KeyD');
    await browser.mouse('mouseMoved', 700, 200);
    await browser.mouse('mousePressed', 700, 200);
    await wait(100);
    await browser.mouse('mouseReleased', 700, 200);
    await wait(300);
    assert.notStrictEqual(await visit.picture('after_keys'), before);
    await browser.press('Escape');
    await visit.title('paused');
    await visit.picture('paused');
    const inputs = inputsOf(await visit.lastRun());
    assert(has(inputs, 1) && has(inputs, 8), 'the recording has no run to the right or no throw');
  },
  async 'the keys of a recorded run reach the goal'(visit, browser) {
    const name = 'pump_it_up';
    const file = fs.readFileSync(path.join(visit.root, 'assets/replays', name + '.replay'));
    const undo = await browser.before(clock.source);
    await browser.open(visit.address + '#level=' + name);
    await browser.until('window.clock?.waits()');
    await browser.value(`clock.run(1, ${clock.tick / 2})`);  // half a tick, so that each frame after it has one
    for (const part of keysOf(file)) {
      for (const code of part.up) await browser.up(code);
      for (const code of part.down) await browser.down(code);
      await browser.value(`clock.run(${part.ticks}, ${clock.tick})`);
    }
    await visit.picture('goal');
    for (let k = 0; k < 10 && !await browser.value('document.title.includes("results")'); ++k)
      await browser.value(`clock.run(10, ${clock.tick})`);
    await visit.title('results');
    await browser.value(`clock.run(30, ${clock.tick})`);
    await visit.picture('results');
    await undo();
    const played = await visit.lastRun();
    const inputs = inputsOf(file);
    assert.deepStrictEqual(inputsOf(played).slice(0, inputs.length), inputs);
    // What the page recorded has the bits of the native game.
    const saved = path.join(visit.root, 'build/web/played.replay');
    fs.writeFileSync(saved, played);
    const verified = execFileSync(path.join(visit.root, 'build/release/bin/ropeswing'),
      ['--replay', saved, '--headless', '--verify'], {encoding: 'utf8'});
    console.log('  ' + verified.trim().split('\n').at(-1));
    assert.match(verified, /verified/);
  },
  async 'fingers run, climb, jump, catch and throw'(visit, browser) {
    await browser.call('Emulation.setTouchEmulationEnabled', {enabled: true, maxTouchPoints: 3});
    await visit.open('#level=line_and_knife');
    const hold = async (...places) => {
      await browser.touch('touchStart', ...places.map(([x, y]) => [x, y]));
      await wait(150);
    };
    const lift = async () => {
      await browser.touch('touchEnd');
      await wait(150);
    };
    await hold([900, 300]);  // the first touch shows the pads
    await lift();
    const center = async name => browser.value(`(() => {
      const pad = [...document.querySelectorAll('.pad')].find(p => p.textContent === '${name}').getBoundingClientRect();
      return [pad.x + pad.width / 2, pad.y + pad.height / 2];
    })()`);
    const drag = async (dx, dy) => {
      await hold([200, 500]);
      await browser.touch('touchMove', [200 + dx, 500 + dy]);
      await wait(300);
      await visit.picture('touch');
      await lift();
    };
    await drag(60, 0);
    await drag(0, -60);
    await hold(await center('Jump'));
    await lift();
    await hold(await center('Catch'));
    await lift();
    await hold([900, 300]);
    await lift();
    await hold(await center('Pause'));
    await lift();
    await visit.title('paused');
    const inputs = inputsOf(await visit.lastRun());
    for (const [what, bit] of [['right', 1], ['up', 6], ['jump', 2], ['catch', 3], ['throw', 8]])
      assert(has(inputs, bit), 'the recording has no ' + what);
    await browser.call('Emulation.setTouchEmulationEnabled', {enabled: false});
  },
  async 'it pauses when another window is in front'(visit, browser) {
    await visit.open('#level=first_swing');
    await wait(300);
    await browser.value('void window.dispatchEvent(new FocusEvent("blur"))');
    await visit.title('paused');
  },
  async 'sound begins with the first gesture'(visit) {
    const fresh = await new Browser().start();  // one that has seen no gesture
    try {
      await fresh.open(visit.address);
      await fresh.until('performance.getEntriesByName("first frame").length > 0');
      assert.strictEqual(await fresh.value(sound), 'suspended');
      await fresh.press('ArrowDown');
      await fresh.until(sound + ' === "running"');
    } finally {
      await fresh.close();
    }
  },
  async 'settings and recordings are kept'(visit, browser) {
    await visit.open('#level=first_swing');
    await browser.press('KeyM');
    await browser.until(`filesIn("${folder}").length > 0`);
    await wait(5000);  // it stores every two seconds
    const saved = await browser.value(settings);
    const run = await visit.lastRun();
    assert.match(saved, /mute/);
    await visit.open();
    assert.strictEqual(await browser.value(settings), saved);
    const kept = await visit.lastRun();
    assert(kept.length > 1000 && run.subarray(0, kept.length).equals(kept) || kept.subarray(0, run.length).equals(run));
  },
  async 'the recording of the last run is downloaded'(visit, browser) {
    const downloads = path.join(visit.root, 'build/web/downloads');
    fs.rmSync(downloads, {recursive: true, force: true});
    fs.mkdirSync(downloads, {recursive: true});
    await browser.call('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: downloads});
    await visit.open('#level=first_swing');
    await wait(1000);
    await browser.press('Escape');
    await visit.title('paused');
    await browser.value('document.getElementById("save").click()');
    const end = Date.now() + 10000;
    const found = () => fs.readdirSync(downloads).filter(name => name.endsWith('.replay'));
    while (found().length === 0 && Date.now() < end) await wait(50);
    assert.match(found()[0] ?? 'nothing', /first_swing/);
    assert(inputsOf(fs.readFileSync(path.join(downloads, found()[0]))).length > 10);
  },
};
