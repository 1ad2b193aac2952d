// "Copy link": to the clipboard, or where the browser has none for the page, to a field.
'use strict';
const assert = require('node:assert');
const {wait} = require('./browser.js');

// A run to share, and a click on the button, as a browser wants it before it gives the clipboard.
const copy = async (visit, browser) => {
  await visit.open('#level=first_swing');
  await wait(1000);
  await browser.press('Escape');
  await visit.title('paused');
  await browser.click('#link');
};
const shown = 'document.getElementById("shown").checkVisibility()';
const field = 'document.getElementById("run")';
const opensTheRun = async (visit, browser, link) => {
  assert.match(link, /^http:\/\/127\.0\.0\.1:\d+\/#replay=[\w-]+$/);
  await browser.open(link);
  await visit.title('first_swing, a replay');
};
const fieldHasTheRun = async (visit, browser, name) => {
  await browser.until(shown);
  await visit.picture(name);
  const link = await browser.value(field + '.value');
  assert.strictEqual(await browser.value('getSelection().toString()'), link, 'the link is not selected');
  return link;
};

module.exports = {
  async 'the link goes to the clipboard'(visit, browser) {
    await browser.allow('clipboard-write', 'granted');
    await browser.allow('clipboard-read', 'granted');
    await copy(visit, browser);
    await browser.until('document.getElementById("bar").textContent.includes("in the clipboard")');
    assert.strictEqual(await browser.value(shown), false);
    const link = await browser.value('navigator.clipboard.readText()');
    await opensTheRun(visit, browser, link);
  },
  async 'without permission the link is shown, selected'(visit, browser) {
    await browser.allow('clipboard-write', 'denied');
    await copy(visit, browser);
    const link = await fieldHasTheRun(visit, browser, 'copy_denied');
    // Keys in the field are not the game's, which is paused and would go on.
    await browser.press('Escape');
    await browser.until('!' + shown);
    assert(await browser.value('document.title.includes("paused")'), 'the key has reached the game');
    await browser.click('#link');
    await browser.until(shown);
    await browser.click('#shown button');
    await browser.until('!' + shown);
    await browser.press('Escape');
    await browser.until('!document.title.includes("paused")');
    await opensTheRun(visit, browser, link);
  },
  async 'without a clipboard the link is shown, selected'(visit, browser) {
    await browser.before('Object.defineProperty(navigator, "clipboard", {value: undefined})');
    await copy(visit, browser);
    await fieldHasTheRun(visit, browser, 'copy_without');
  },
};
