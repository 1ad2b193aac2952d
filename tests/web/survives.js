// What a browser takes away: the graphics hardware, the storage, the frames of a page in the background.
'use strict';
const assert = require('node:assert');
const {wait} = require('./browser.js');

module.exports = {
  async 'a lost WebGL context comes back'(visit, browser) {
    await visit.open('#level=first_swing');
    await browser.press('KeyP');
    await visit.title('paused');
    await wait(500);
    const before = await visit.picture('before_loss');
    await browser.value(`void (window.loss = (at('canvas').getContext('webgl2') ?? at('canvas').getContext('webgl'))
      .getExtension('WEBGL_lose_context')).loseContext()`);
    await wait(500);
    assert.notStrictEqual(await visit.picture('lost'), before);
    await browser.value('window.loss.restoreContext()');
    await wait(1000);
    assert.strictEqual(await visit.picture('restored'), before);
    await browser.press('Escape');
    await browser.until('!document.title.includes("paused")');
    await wait(300);
    await browser.press('KeyP');
    await visit.title('paused');
  },
  async 'a blocked storage is done without'(visit, browser) {
    const undo = await browser.before(
      'Object.defineProperty(window, "indexedDB", {get() { throw new Error("blocked"); }})');
    await visit.open('#level=first_swing');
    await wait(3000);  // it would have been stored
    await visit.title('first_swing');
    await undo();
  },
  async 'a page in the background pauses, and goes on'(visit, browser) {
    await visit.open('#level=first_swing');
    await wait(500);
    const {targetId} = await browser.call('Target.createTarget', {url: 'about:blank', background: false});
    await browser.until('document.hidden', 5000).catch(async () => {
      // Without a screen, Chromium may show both: the page is told what another browser would tell it.
      await browser.value(`Object.defineProperty(document, 'hidden', {get: () => window.isAway, configurable: true});
        window.isAway = true; document.dispatchEvent(new Event('visibilitychange'))`);
    });
    await browser.until('(Module.SDL2?.audioContext?.state ?? "suspended") === "suspended"');
    await wait(1000);
    await browser.call('Target.closeTarget', {targetId});
    await browser.value('window.isAway = false; void document.dispatchEvent(new Event("visibilitychange"))');
    await visit.title('paused');
    await browser.press('Escape');
    await browser.until('!document.title.includes("paused")');
  },
};
