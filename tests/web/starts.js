// The page starts, from links too, and says in words why it does not.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const zlib = require('node:zlib');

const recorded = (root, name) => fs.readFileSync(path.join(root, 'assets/replays', name + '.replay'));

module.exports = {
  async 'the page is 3 MB at most, gzipped'({root}) {
    const folder = path.join(root, 'build/web/page');
    const bytes = fs.readdirSync(folder)
      .reduce((sum, name) => sum + zlib.gzipSync(fs.readFileSync(path.join(folder, name)), {level: 9}).length, 0);
    console.log(`  ${Math.round(bytes / 1000)} kB`);
    assert(bytes <= 3e6);
  },
  async 'the first frame is shown'(visit, browser) {
    await visit.open();
    const ms = await browser.value('performance.getEntriesByName("first frame")[0].startTime');
    console.log(`  after ${Math.round(ms)} ms; the bar is 3000 ms on an idle machine`);
    await visit.picture('title');
  },
  async 'all levels are there'(visit, browser) {
    await visit.open();
    const levels = fs.readdirSync(path.join(visit.root, 'assets/levels')).filter(name => name.endsWith('.tmj')).sort();
    assert.deepStrictEqual(await browser.value('filesIn("/assets/levels").filter(n => n.endsWith(".tmj")).sort()'), levels);
    await visit.open('#level=the_harbour');
    await visit.title('the_harbour');
    await visit.picture('level');
  },
  async 'a link shows a run'(visit, browser) {
    const file = recorded(visit.root, 'first_swing').toString('base64');
    await visit.open();
    const link = await browser.value(`Recording.toLink(Uint8Array.from(atob("${file}"), c => c.charCodeAt(0)))`);
    console.log(`  first_swing is a link of ${link.length} letters`);
    await visit.open('#replay=' + link);
    await visit.title('first_swing, a replay');
    await visit.picture('link');
  },
  async 'a file that is opened shows a run'(visit, browser) {
    await visit.open();
    const {root: {nodeId}} = await browser.call('DOM.getDocument');
    const input = await browser.call('DOM.querySelector', {nodeId, selector: '#open'});
    await browser.call('DOM.setFileInputFiles',
      {nodeId: input.nodeId, files: [path.join(visit.root, 'assets/replays/trampoline.replay')]});
    await visit.title('trampoline, a replay');
  },
  async 'a damaged link or recording gets a sentence of the game'(visit, browser) {
    await visit.refusal('#level=nowhere', 'nowhere');
    await visit.refusal('#replay=nonsense', 'the link: byte 0: not a replay');
    const damaged = recorded(visit.root, 'first_swing');
    damaged[damaged.length >> 1] ^= 1;
    await visit.open();
    await browser.value(`sessionStorage.setItem("opened", "${damaged.toString('base64')}")`);
    await visit.refusal('#opened', 'the recording: byte ');
  },
  async 'without WebAssembly it says so'(visit, browser) {
    const undo = await browser.before('delete window.WebAssembly');
    await visit.refusal('', 'WebAssembly');
    await undo();
  },
  async 'without WebGL it plays, or says why not'(visit, browser) {
    const undo = await browser.before(`{
      const context = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext =
        function(kind, ...more) { return kind.includes('webgl') ? null : context.call(this, kind, ...more); };
    }`);
    await visit.open();
    await visit.picture('without_webgl');
    await undo();
  },
};
