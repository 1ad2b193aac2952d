// The lab in the page: its scenes by links, sliders by mouse and finger, and its own words for a link that is wrong.
'use strict';
const assert = require('node:assert');
const {wait} = require('./browser.js');

// The sliders' column is 252 px wide at 1280 × 720, and each line 44 px high, below a strip of 44 px
// (game/lab_view/layout.cpp, console.cpp).
const bar = (line, share) => [1280 - 252 + 10 + share * 232, 44 + 44 * line + 33];
const drag = async (browser, from, to) => {
  await browser.mouse('mouseMoved', ...from);
  await browser.mouse('mousePressed', ...from);
  for (let k = 1; k <= 5; ++k) {
    await browser.mouse('mouseMoved', from[0] + k / 5 * (to[0] - from[0]), from[1] + k / 5 * (to[1] - from[1]));
    await wait(60);
  }
};

module.exports = {
  async 'a link opens a scene of the lab, and a slider turns'(visit, browser) {
    await visit.open('#lab=heavy_load');
    await visit.title('Heavy load');
    await wait(1500);
    assert.strictEqual(await browser.value('getComputedStyle(document.getElementById("bar")).display'), 'none');
    const before = await visit.picture('lab_heavy_load');
    await drag(browser, bar(0, 0.33), bar(0, 1));
    await browser.mouse('mouseReleased', ...bar(0, 1));
    await wait(500);
    assert.notStrictEqual(await visit.picture('lab_slider'), before);
    await drag(browser, [600, 300], [520, 200]);  // the world: what is nearest follows
    await visit.picture('lab_drag');
    await browser.mouse('mouseReleased', 520, 200);
  },
  async 'every scene of the lab opens by a click'(visit, browser) {
    await visit.open('#lab=heavy_load');
    const titles = ['Heavy load', 'Capstan', 'Pile', 'Strips', 'Buckling', 'Bridge', 'A thousand lamps', 'Thesis, A', 'Thesis, B',
      'Thesis, C', 'Thesis, D'];
    for (const [k, title] of titles.entries()) {
      const at = [90, 44 + 33 * k + 16];
      await browser.mouse('mouseMoved', ...at);
      await browser.mouse('mousePressed', ...at);
      await browser.mouse('mouseReleased', ...at);
      await visit.title(title);
      await wait(600);
      await visit.picture('lab_' + title.replace(/\W+/g, '_').toLowerCase());
    }
  },
  async 'a finger drags in the lab, without the buttons of a level'(visit, browser) {
    await browser.call('Emulation.setTouchEmulationEnabled', {enabled: true, maxTouchPoints: 2});
    await visit.open('#lab=bridge');
    await browser.touch('touchStart', [300, 300]);
    await browser.touch('touchEnd');
    await browser.until('document.getElementById("touch").classList.contains("plain")');
    const shown = await browser.value(
      '[...document.querySelectorAll("#touch .pad")].filter(pad => getComputedStyle(pad).display !== "none").length');
    assert.strictEqual(shown, 0);
    await browser.touch('touchStart', [90, 44 + 33 + 16]);  // the second scene
    await browser.touch('touchEnd');
    await visit.title('Capstan');
    await visit.picture('lab_touch');
  },
  async 'a wrong scene of the lab gets a sentence of the game'(visit) {
    await visit.refusal('#lab=nonsense', 'heavy_load, capstan');
  },
};
