// A visit to the page that game/web/build made: it is served, Chromium opens it, and a test asks and acts.
'use strict';
const fs = require('node:fs');
const http = require('node:http');
const path = require('node:path');
const {Browser} = require('./browser.js');

const root = path.join(__dirname, '../..');
const served = path.join(root, 'build/web/page');
const pictures = path.join(root, 'build/web/pictures');

const types = {html: 'text/html', js: 'text/javascript', css: 'text/css', wasm: 'application/wasm'};
const serve = (request, response) => {
  const name = request.url === '/' ? 'index.html' : path.basename(request.url.split('?')[0]);
  const file = path.join(served, name);
  if (!fs.existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, {'Content-Type': types[name.split('.').at(-1)] ?? 'application/octet-stream'});
  fs.createReadStream(file).pipe(response);
};

class Visit {
  constructor(browser, address) {
    this.browser = browser;
    this.address = address;
    this.root = root;
  }
  async open(hash = '') {
    await this.browser.open(this.address + hash);
    await this.browser.until('performance.getEntriesByName("first frame").length > 0');
  }
  picture(name) { return this.browser.picture(path.join(pictures, name + '.png')); }
  title(part) { return this.browser.until(`document.title.includes("${part}")`); }
  async refusal(hash, part) {
    await this.browser.open(this.address + hash);
    await this.browser.until(`document.getElementById("sentence").textContent.includes("${part}")`);
    console.log('  ' + await this.browser.value('document.getElementById("sentence").textContent'));
  }
  // The last recording that the page has stored, as a Buffer.
  async lastRun() {
    const text = await this.browser.value(
      '(() => { const run = lastRun(); return run && btoa(Array.from(run.bytes, b => String.fromCharCode(b)).join("")); })()');
    return text && Buffer.from(text, 'base64');
  }
}

// Calls act(visit, browser), and ends both with it.
const inChromium = async act => {
  fs.mkdirSync(pictures, {recursive: true});
  const server = http.createServer(serve);
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  const browser = await new Browser().start();
  try {
    await act(new Visit(browser, `http://127.0.0.1:${server.address().port}/`), browser);
  } catch (error) {
    console.error(error.message);
    process.exitCode = 2;
  }
  await browser.close();
  server.close();
  server.closeAllConnections();
};

module.exports = {inChromium};
