// Opens the page of a report in a headless Chromium and uses it: the first screen, hover, click, play, tap, print.
//   node tests/study/page_in_browser.mjs REPORT/index.html FOLDER     writes the pictures of the screens to FOLDER
// Exits with 1 and a sentence for each thing that is not as it must be. It needs the packages chromium and nodejs.
import {spawn} from 'node:child_process';
import {mkdirSync, mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

if (process.argv.length !== 4) {
  console.error('usage: node page_in_browser.mjs REPORT/index.html FOLDER');
  process.exit(2);
}
const url = pathToFileURL(resolve(process.argv[2])).href;
const folder = resolve(process.argv[3]);
mkdirSync(folder, {recursive: true});
const profile = mkdtempSync(join(tmpdir(), 'page_in_browser_'));
const browser = spawn('chromium', ['--headless=new', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe',
                                   '--user-data-dir=' + profile, 'about:blank'],
                      {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
browser.on('error', error => {
  console.error('chromium does not start: ' + error.message + '; the packages are chromium and nodejs');
  process.exit(2);
});

// The protocol of the browser: messages of JSON that end with a zero byte.
let id = 0, rest = '';
const waiting = new Map(), complaints = [], listeners = [];
browser.stdio[4].on('data', chunk => {
  rest += chunk;
  for (let end; (end = rest.indexOf('\0')) >= 0; rest = rest.slice(end + 1)) {
    const message = JSON.parse(rest.slice(0, end));
    if (message.id) {
      waiting.get(message.id)(message);
    } else {
      listeners.forEach(listener => listener(message));
    }
  }
});
let session;
const call = (method, params = {}) => new Promise((done, fail) => {
  waiting.set(++id, message => message.error ? fail(new Error(method + ': ' + message.error.message)) : done(message.result));
  browser.stdio[3].write(JSON.stringify({id, method, params, sessionId: session}) + '\0');
});
const event = method => new Promise(done => {
  listeners.push(message => { if (message.method === method) done(message.params); });
});
listeners.push(message => {
  if (message.method === 'Runtime.exceptionThrown') {
    complaints.push('exception: ' + (message.params.exceptionDetails.exception?.description ?? 'unknown'));
  }
  if (message.method === 'Runtime.consoleAPICalled' && message.params.type === 'error') complaints.push('console: an error');
  if (message.method === 'Log.entryAdded' && message.params.entry.level === 'error') {
    complaints.push('log: ' + message.params.entry.text);
  }
  if (message.method === 'Network.requestWillBeSent' && /^https?:/.test(message.params.request.url)) {
    complaints.push('it loads ' + message.params.request.url + ', and must work offline');
  }
});
const js = async expression => {
  const answer = await call('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
  if (answer.exceptionDetails) throw new Error(answer.exceptionDetails.exception.description);
  return answer.result.value;
};
const expect = (fact, sentence) => { if (!fact) complaints.push(sentence); };
const picture = async name => {
  const {data} = await call('Page.captureScreenshot', {format: 'png'});
  writeFileSync(join(folder, name + '.png'), Buffer.from(data, 'base64'));
};
const size = async (width, height, mobile) => {
  await call('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile});
  await call('Emulation.setTouchEmulationEnabled', {enabled: mobile});
  const loaded = event('Page.loadEventFired');
  await call('Page.navigate', {url});
  await loaded;
};
const middle = point => js(`(() => { const b = document.querySelector('.point[data-point="${point}"]').getBoundingClientRect();
  return {x: b.x + b.width / 2, y: b.y + b.height / 2}; })()`);
const mouse = (type, at, more = {}) => call('Input.dispatchMouseEvent', {type, ...at, ...more});
const click = async at => {
  await mouse('mouseMoved', at);
  await mouse('mousePressed', at, {button: 'left', clickCount: 1});
  await mouse('mouseReleased', at, {button: 'left', clickCount: 1});
};
// Waits for frames of the film, not for a time.
const moves = () => js(`new Promise(done => { const time = document.getElementById('time'), before = time.textContent;
  let frames = 0; (function look() { time.textContent !== before ? done(true) : ++frames > 900 ? done(false)
  : requestAnimationFrame(look); })(); })`);
const colours = () => js(`(() => { const c = document.getElementById('canvas');
  const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, seen = new Set();
  for (let k = 0; k < d.length; k += 4) seen.add((d[k] << 16) + (d[k + 1] << 8) + d[k + 2]); return seen.size; })()`);

// Texts of the front that lie in each other by more than 2 px.
const overlapping = () => js(`(() => { const texts = [...document.querySelectorAll('#plots text')], found = [];
  texts.forEach((t, k) => texts.slice(0, k).forEach(s => { const a = t.getBoundingClientRect(), b = s.getBoundingClientRect();
    if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 2)
      found.push(s.textContent + ' and ' + t.textContent); }));
  return found.join(', '); })()`);

async function firstScreen() {
  await size(1280, 720, false);
  const box = name => js(`document.querySelector('${name}').getBoundingClientRect().bottom`);
  expect(await js(`document.getElementById('headline') !== null`), 'there is no recommendation');
  expect(await box('#headline') < 200, 'the recommendation is not at the top');
  expect(await box('#plots svg') <= 720, 'the front does not fit on the first screen');
  for (const mark of ['1 % of a frame', '10 %']) {
    expect(await js(`document.querySelector('#plots svg').textContent.includes('${mark}')`), 'no line of ' + mark);
  }
  expect(await overlapping() === '', 'texts lie in each other: ' + await overlapping());
  await picture('first_screen');
}

async function hoverAndPlay() {
  const films = await js(`data.films === null ? [] : data.points.map((p, k) => k).filter(hasFilm)`);
  const point = films.at(-1) ?? 0;
  await mouse('mouseMoved', await middle(point));
  const setting = await js(`data.points[${point}].setting`);
  expect((await js(`about.textContent`)).includes(setting), 'hovering does not show ' + setting);
  if (films.length === 0) return;
  expect(await js(`document.getElementById('film').hidden`), 'a film is shown before a click');
  await click(await middle(point));
  expect(await js(`!document.getElementById('film').hidden && document.getElementById('film').dataset.point === '${point}'`),
         'a click does not open the film of ' + setting);
  expect(await moves(), 'the film does not move');
  expect(await colours() > 3, 'the film is blank');
  await js(`document.getElementById('worst').click()`);
  expect((await js(`document.getElementById('time').textContent`)).includes('greatest error'), 'no greatest error');
  expect(!(await js(`film.runs`)), 'the film runs on at the greatest error');
  await picture('film');
  const shows = await js(`document.querySelectorAll('button.show:not([hidden])').length`);
  if (shows > 0) {
    await js(`document.querySelector('button.show:not([hidden])').click()`);
    expect(await js(`document.getElementById('film').dataset.point === document.querySelector('button.show:not([hidden])').dataset.point`),
           'a failure is not shown');
    await picture('failure');
  }
}

async function smallScreen() {
  await size(360, 740, true);
  expect(await js(`document.documentElement.scrollWidth`) <= 360, 'the page is wider than 360 px');
  expect(await overlapping() === '', 'at 360 px texts lie in each other: ' + await overlapping());
  expect(await js(`[...document.querySelectorAll('.legend > span')].every(s => s.getClientRects().length === 1)`),
         'an entry of the legend is broken at 360 px');
  const at = await middle(await js(`data.recommended ?? 0`));
  await js(`scrollTo(0, ${Math.max(0, at.y - 300)})`);
  const now = await middle(await js(`data.recommended ?? 0`));
  await call('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: [now]});
  await call('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
  await js(`new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))`);
  expect(await js(`data.films === null || !document.getElementById('film').hidden`), 'a tap does not play');
  expect(await js(`document.documentElement.scrollWidth`) <= 360, 'the page with a film is wider than 360 px');
  await js(`scrollTo(0, 0)`);
  await picture('small_screen');
}

async function darkAndPrint() {
  await size(1280, 720, false);
  await call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: 'dark'}]});
  expect(await js(`getComputedStyle(document.body).backgroundColor`) === 'rgb(22, 22, 22)', 'there is no dark page');
  await picture('dark');
  await call('Emulation.setEmulatedMedia', {media: 'print', features: []});
  expect(await js(`getComputedStyle(document.getElementById('film')).display`) === 'none', 'a film is printed');
  const {data} = await call('Page.printToPDF', {});
  writeFileSync(join(folder, 'print.pdf'), Buffer.from(data, 'base64'));
}

try {
  const {targetId} = await call('Target.createTarget', {url: 'about:blank'});
  ({sessionId: session} = await call('Target.attachToTarget', {targetId, flatten: true}));
  for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await call(domain + '.enable');
  await firstScreen();
  await hoverAndPlay();
  await smallScreen();
  await darkAndPrint();
} catch (error) {
  complaints.push(error.message);
}
browser.kill();
await new Promise(done => browser.once('exit', done));
rmSync(profile, {recursive: true, force: true});
complaints.forEach(complaint => console.error('page: ' + complaint));
if (complaints.length === 0) console.log('the page works: pictures in ' + folder);
process.exit(complaints.length > 0 ? 1 : 0);
