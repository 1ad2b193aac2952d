// A gamepad in the page. SDL asks the browser for the pads in each frame, so a test answers in the browser's place.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const {wait} = require('./browser.js');
const clock = require('./clock.js');
const {inputsOf} = require('./recorded_keys.js');

// The pads of the page, and what a browser tells when one comes or goes. Places are those of the standard gamepad.
const inPage = () => {
  const places = [null, null, null, null];
  navigator.getGamepads = () => places;
  const report = (type, pad) => window.dispatchEvent(Object.assign(new Event(type), {gamepad: pad}));
  const released = () => ({pressed: false, touched: false, value: 0});
  let time = 1;
  window.pads = {
    connect(index) {
      places[index] = {id: 'A gamepad of a test', index, connected: true, mapping: 'standard', timestamp: ++time,
        axes: [0, 0, 0, 0], buttons: Array.from({length: 17}, released)};
      report('gamepadconnected', places[index]);
    },
    disconnect(index) {
      const pad = places[index];
      places[index] = null;
      report('gamepaddisconnected', Object.assign(pad, {connected: false}));
    },
    hold(index, buttons) {
      const pad = places[index];
      pad.timestamp = ++time;
      pad.buttons = pad.buttons.map((_, k) => (buttons.includes(k) ? {pressed: true, touched: true, value: 1} : released()));
    },
    tilt(index, axis, share) {
      places[index].timestamp = ++time;
      places[index].axes[axis] = share;
    },
  };
};
const source = `(${inPage})()`;
const button = {a: 0, b: 1, x: 2, y: 3, start: 9, up: 12, down: 13, left: 14, right: 15};
// By the bits of a recorded input, as game/settings/bindings.cpp binds them.
const buttons = [button.left, button.right, button.a, button.x, null, null, button.up, button.down];

const hold = (browser, ...held) => browser.value(`pads.hold(0, ${JSON.stringify(held)})`);
const press = async (browser, which) => {
  await hold(browser, which);
  await wait(150);
  await hold(browser);
  await wait(150);
};
// The ticks in which a button of the recording is held.
const ticksWith = (file, bit) => inputsOf(file).filter(input => input >> bit & 1).length;

module.exports = {
  async 'a gamepad runs, jumps, catches and reaches the goal'(visit, browser) {
    const name = 'pump_it_up';
    const inputs = inputsOf(fs.readFileSync(path.join(visit.root, 'assets/replays', name + '.replay')));
    await browser.before(clock.source);
    await browser.before(source);
    await browser.open(visit.address + '#level=' + name);
    await browser.until('window.clock?.waits()');
    await browser.value('pads.connect(0)');
    await browser.value(`clock.run(1, ${clock.tick / 2})`);  // half a tick, so that each frame after it has one
    for (let from = 0, to = 0; from < inputs.length; from = to) {
      while (to < inputs.length && inputs[to] === inputs[from]) ++to;
      const held = buttons.filter((_, bit) => inputs[from] >> bit & 1);
      assert(!held.includes(null) && inputs[from] < 1 << buttons.length, 'a button of the recording has none here');
      await hold(browser, ...held);
      await browser.value(`clock.run(${to - from}, ${clock.tick})`);
    }
    await hold(browser);
    for (let k = 0; k < 10 && !await browser.value('document.title.includes("results")'); ++k)
      await browser.value(`clock.run(10, ${clock.tick})`);
    await visit.title('results');
    const played = inputsOf(await visit.lastRun());
    assert.deepStrictEqual(played.slice(0, inputs.length), inputs);
    for (const bit of [1, 2, 3]) assert(inputs.some(input => input >> bit & 1), 'the recording has no use of button ' + bit);
  },
  async 'a stick runs, and a gamepad comes and goes while it plays'(visit, browser) {
    await browser.before(source);
    await visit.open('#level=line_and_knife');
    await browser.value('pads.connect(0)');
    await wait(300);
    await visit.picture('pad_found');
    await press(browser, button.a);
    // As a thumb does: SDL takes the first value of an axis for that at rest.
    for (const share of [0.1, 0.5, 1]) {
      await browser.value(`pads.tilt(0, 0, ${share})`);
      await wait(150);
    }
    await wait(500);
    await browser.value('pads.disconnect(0)');
    await visit.title('paused');
    await visit.picture('pad_lost');
    const ran = ticksWith(await visit.lastRun(), 1);
    assert(ran > 0, 'the recording has no run to the right');
    assert(ticksWith(await visit.lastRun(), 2) > 0, 'the recording has no jump');
    await browser.value('pads.connect(0)');
    await wait(150);
    await press(browser, button.start);
    await browser.until('!document.title.includes("paused")');
    await wait(500);
    await press(browser, button.start);
    await visit.title('paused');
    assert.strictEqual(ticksWith(await visit.lastRun(), 1), ran, 'the stick of the pad that went is still held');
  },
  async 'a gamepad that is there before the page chooses in the menus and in the lab'(visit, browser) {
    await browser.before(source + '; pads.connect(0)');
    await visit.open();
    await press(browser, button.down);
    await press(browser, button.a);
    await visit.title('Heavy load');
    await press(browser, button.down);
    await press(browser, button.a);
    await visit.title('Capstan');
    await visit.picture('pad_lab');
    await press(browser, button.b);
    await visit.title('title');
    await press(browser, button.up);
    await press(browser, button.a);
    await visit.title('levels');
    await press(browser, button.right);
    await press(browser, button.a);
    await browser.until('!document.title.includes("levels")');
    await press(browser, button.start);
    await visit.title('paused');
    await visit.picture('pad_menu');
  },
};
