// Headless Chromium, driven through its DevTools pipe: pages, real key events, pictures, and what the console said.
'use strict';
const {spawn} = require('node:child_process');
const {mkdtempSync, rmSync} = require('node:fs');
const {tmpdir} = require('node:os');
const path = require('node:path');

const wait = ms => new Promise(done => setTimeout(done, ms));

class Browser {
  constructor(...flags) {
    this.profile = mkdtempSync(path.join(tmpdir(), 'ropeswing-chromium-'));
    this.process = spawn('chromium', ['--headless=new', '--no-sandbox', '--remote-debugging-pipe', '--window-size=1280,720',
      '--hide-scrollbars', '--no-first-run', '--autoplay-policy=document-user-activation-required', `--user-data-dir=${this.profile}`,
      ...flags, 'about:blank'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    this.next = 1;
    this.waiting = new Map();
    this.errors = [];
    this.scripts = new Set();
    let rest = '';
    this.process.stdio[4].on('data', data => {
      const parts = (rest + data).split('\0');
      rest = parts.pop();
      for (const part of parts) this.receive(JSON.parse(part));
    });
  }

  receive(message) {
    if (message.id) {
      const {done, fail} = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      return message.error ? fail(new Error(message.error.message)) : done(message.result);
    }
    const {method, params} = message;
    if (method === 'Runtime.exceptionThrown')
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.errors.push(params.entry.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'assert'].includes(params.type))
      this.errors.push(params.args.map(arg => arg.value ?? arg.description).join(' '));
  }

  call(method, params = {}) {
    const id = this.next++;
    const message = {id, method, params, ...(this.session && {sessionId: this.session})};
    this.process.stdio[3].write(JSON.stringify(message) + '\0');
    return new Promise((done, fail) => this.waiting.set(id, {done, fail}));
  }

  async start() {
    const {targetInfos} = await this.call('Target.getTargets');
    const {targetId} = targetInfos.find(target => target.type === 'page');
    this.session = (await this.call('Target.attachToTarget', {targetId, flatten: true})).sessionId;
    for (const part of ['Page', 'Runtime', 'Log']) await this.call(part + '.enable');
    // The page alone has this size, without what the window of a browser has around it.
    await this.call('Emulation.setDeviceMetricsOverride', {width: 1280, height: 720, deviceScaleFactor: 1, mobile: false});
    return this;
  }

  async open(url) {
    await this.call('Page.navigate', {url: 'about:blank'});
    await this.call('Page.navigate', {url});
  }

  async value(expression) {
    const {result, exceptionDetails} = await this.call('Runtime.evaluate',
      {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // Waits until an expression of the page is true; the milliseconds are those of a slow machine.
  async until(expression, ms = 60000) {
    for (const end = Date.now() + ms; Date.now() < end; await wait(50)) {
      if (await this.value(expression).catch(() => false)) return;
    }
    throw new Error('never became true: ' + expression);
  }

  // Real key events, by the code of a key: KeyD, Space, Escape.
  async down(code) { await this.key('keyDown', code); }
  async up(code) { await this.key('keyUp', code); }
  async press(code) {
    await this.down(code);
    await this.up(code);
  }
  async key(type, code) {
    const letter = /^Key(.)$/.exec(code)?.[1];
    const key = letter?.toLowerCase() ?? {Space: ' '}[code] ?? code;
    const number = letter?.charCodeAt(0) ?? {Space: 32, Escape: 27, Enter: 13, ArrowDown: 40}[code];
    await this.call('Input.dispatchKeyEvent', {type, code, key, windowsVirtualKeyCode: number});
  }

  async mouse(type, x, y) {
    const held = type === 'mousePressed' ? 1 : 0;
    await this.call('Input.dispatchMouseEvent',
      {type, x, y, button: type === 'mouseMoved' ? 'none' : 'left', buttons: held, clickCount: 1});
  }

  // A click on the middle of an element of the page.
  async click(selector) {
    const at = await this.value(`(() => {
      const place = document.querySelector('${selector}').getBoundingClientRect();
      return [place.x + place.width / 2, place.y + place.height / 2];
    })()`);
    for (const type of ['mouseMoved', 'mousePressed', 'mouseReleased']) await this.mouse(type, ...at);
  }

  // Answers for the user: 'granted' or 'denied', until forget().
  async allow(permission, setting) { await this.call('Browser.setPermission', {permission: {name: permission}, setting}); }

  // Fingers at places [x, y]; none lifts them all.
  async touch(type, ...places) {
    await this.call('Input.dispatchTouchEvent', {type, touchPoints: places.map(([x, y], id) => ({x, y, id}))});
  }

  // Runs a script in each page before its own, until the function that it returns is called.
  async before(source) {
    const {identifier} = await this.call('Page.addScriptToEvaluateOnNewDocument', {source});
    this.scripts.add(identifier);
    return () => {
      this.scripts.delete(identifier);
      return this.call('Page.removeScriptToEvaluateOnNewDocument', {identifier});
    };
  }

  // Leaves the page, and what a test that failed has set up for it.
  async forget() {
    for (const identifier of this.scripts) await this.call('Page.removeScriptToEvaluateOnNewDocument', {identifier});
    this.scripts.clear();
    await this.call('Browser.resetPermissions');
    await this.call('Emulation.setTouchEmulationEnabled', {enabled: false});
    await this.call('Page.navigate', {url: 'about:blank'});
  }

  async picture(file) {
    const {data} = await this.call('Page.captureScreenshot', {format: 'png'});
    require('node:fs').writeFileSync(file, Buffer.from(data, 'base64'));
    return data;
  }

  // Asks Chromium to end, and removes its profile when the last of its processes has let go of it.
  async close() {
    const ended = new Promise(done => this.process.on('exit', done));
    await this.call('Browser.close').catch(() => {});
    await ended;
    for (let left = 50; left > 0; --left) {
      try {
        return rmSync(this.profile, {recursive: true, force: true});
      } catch {
        await wait(100);
      }
    }
    console.error(`the profile ${this.profile} cannot be removed`);
  }
}

module.exports = {Browser, wait};
