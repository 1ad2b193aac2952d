#include "tests/study/page.h"

namespace study {

// The plot is drawn at the width of the window, so that its text keeps its size on a small screen. The film draws the
// converged run and the setting over each other at the same scale; the inset magnifies the place of the greatest error.
const char* const page_script = R"js('use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const colors = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#7f3c8d', '#888888'];
const about = document.getElementById('about');
const methods = [...new Set(data.points.map(p => p.method))];
const groups = [...new Set(data.points.map(p => p.group))];
const digits = value => value === null ? 'unknown' : Number(value.toPrecision(3)).toString();
let chosen = data.recommended ?? data.present;

function words(k) {
  const p = data.points[k];
  const marks = [k === data.recommended ? 'recommended' + (data.recommendedWith && ' with ' + data.recommendedWith) : '', k === data.present ? 'present setting' : '',
                 p.front ? 'on the front' : '', p.compared ? '' : 'another motion: not compared'];
  return p.method + ' ' + p.setting + '\n' + digits(p.cost) + ' µs a tick, 99 % within ' + digits(p.p99) + ' µs by the clock, ' +
         (p.failure ? 'failed: ' + p.failure : data.axis + ' ' + digits(p.error)) + '\n' +
         marks.filter(m => m).join(', ') + (hasFilm(k) ? '\nclick: play it' : '');
}
function describe(k) {
  about.textContent = k === null ? 'Point at a setting to read it.' : words(k);
}

function element(parent, name, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}

function ticks(low, high) {
  const all = [];
  for (let e = Math.ceil(Math.log10(low)); e <= Math.floor(Math.log10(high)); ++e) all.push(e);
  return all;
}
const superscript = e => '10' + [...String(e)].map(c => c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]).join('');

function drawGroup(group) {
  const indices = data.points.map((p, k) => k).filter(k => data.points[k].group === group);
  const shown = indices.filter(k => data.points[k].cost > 0);
  const errors = shown.map(k => data.points[k]).filter(p => !p.failure && p.error > 0).map(p => p.error);
  const place = document.getElementById('plots');
  const width = Math.max(300, place.clientWidth), height = Math.min(480, Math.max(300, 0.62 * width));
  const left = 52, right = 12, top = group ? 26 : 10, bottom = 44;
  const costs = shown.map(k => data.points[k].cost);
  const x0 = 0.6 * Math.min(...costs, 120), x1 = 1.6 * Math.max(...costs, 2000);
  const e0 = 0.5 * Math.min(...errors, 1e-2), e1 = 6 * Math.max(...errors, 1e-2);
  const x = v => left + (width - left - right) * Math.log(v / x0) / Math.log(x1 / x0);
  const y = v => height - bottom - (height - top - bottom) * Math.log(v / e0) / Math.log(e1 / e0);
  const svg = element(place, 'svg', {viewBox: `0 0 ${width} ${height}`, height, role: 'group',
                                     'aria-label': 'Error against cost, both logarithmic ' + group});
  if (group) element(svg, 'text', {x: left, y: 16}, group);
  for (const e of ticks(x0, x1)) {
    element(svg, 'line', {class: 'grid', x1: x(10 ** e), x2: x(10 ** e), y1: top, y2: height - bottom});
    element(svg, 'text', {x: x(10 ** e), y: height - bottom + 16, 'text-anchor': 'middle'}, superscript(e));
  }
  for (const e of ticks(e0, e1)) {
    element(svg, 'line', {class: 'grid', x1: left, x2: width - right, y1: y(10 ** e), y2: y(10 ** e)});
    element(svg, 'text', {x: left - 6, y: y(10 ** e) + 4, 'text-anchor': 'end'}, superscript(e));
  }
  for (const [us, label, row] of [[167, '1 % of a frame', 32], [1670, '10 %', 48]]) {
    if (us < x0 || us > x1) continue;
    element(svg, 'line', {class: 'frame', x1: x(us), x2: x(us), y1: top, y2: height - bottom});
    const before = x(us) - left > 8 * label.length;  // room for it, beside the axis
    element(svg, 'text', {class: 'soft', x: x(us) + (before ? -4 : 4), y: top + row, 'text-anchor': before ? 'end' : 'start'},
            label);
  }
  element(svg, 'text', {x: 0.5 * (left + width), y: height - 8, 'text-anchor': 'middle'}, 'cost [µs a tick]');
  element(svg, 'text', {x: 14, y: 0.5 * height, 'text-anchor': 'middle', transform: `rotate(-90 14 ${0.5 * height})`},
          data.axis);
  const front = shown.filter(k => data.points[k].front).sort((a, b) => data.points[a].cost - data.points[b].cost);
  const at = k => [x(data.points[k].cost), data.points[k].failure ? top + 10 : y(Math.max(data.points[k].error, e0))];
  element(svg, 'polyline', {class: 'front', points: front.map(at).map(p => p.join()).join(' ')});
  for (const k of shown) {
    const p = data.points[k];
    if (!p.failure && p.error === null) continue;
    const [cx, cy] = at(k);
    const color = colors[methods.indexOf(p.method) % colors.length];
    if (k === data.recommended) element(svg, 'circle', {class: 'ring', cx, cy, r: 12});
    if (k === data.present) element(svg, 'rect', {class: 'ring', x: cx - 10, y: cy - 10, width: 20, height: 20});
    const mark = p.failure
        ? element(svg, 'path', {d: `M${cx - 5} ${cy - 5}l10 10m0 -10l-10 10`, stroke: color, 'stroke-width': 3})
        : element(svg, 'circle', {cx, cy, r: p.compared ? 6 : 3, fill: color});
    mark.classList.add('point');
    mark.dataset.point = k;
    for (const [key, value] of [['tabindex', 0], ['role', 'button'], ['aria-label', words(k)]]) mark.setAttribute(key, value);
    mark.addEventListener('focus', () => describe(k));
    mark.addEventListener('keydown', event => { if (event.key === 'Enter' || event.key === ' ') choose(k, event); });
  }
  const nearest = event => {
    const box = svg.getBoundingClientRect(), scale = width / box.width;
    let best = null, least = 26;
    for (const k of shown) {
      const [cx, cy] = at(k);
      const away = Math.hypot((event.clientX - box.left) * scale - cx, (event.clientY - box.top) * scale - cy);
      if (away < least) [best, least] = [k, away];
    }
    return best;
  };
  svg.addEventListener('pointermove', event => { const k = nearest(event); if (k !== null) describe(k); });
  svg.addEventListener('pointerleave', () => describe(chosen));
  svg.addEventListener('click', event => { const k = nearest(event); if (k !== null) choose(k, event); });
}

function legend() {
  const line = document.createElement('p');
  line.className = 'legend';
  const add = (sign, text, color) => {
    const item = document.createElement('span'), mark = document.createElement('span');
    mark.textContent = sign + ' ';
    if (color) mark.style.color = color;
    item.append(mark, text);
    line.append(item, ' ');
  };
  methods.forEach((method, m) => add('●', method, colors[m % colors.length]));
  add('—', 'front');
  if (data.recommended !== null) add('○', 'recommended');
  if (data.present !== null) add('□', 'present setting');
  if (data.points.some(p => p.failure)) add('×', 'failed');
  if (data.points.some(p => !p.compared)) add('•', 'another motion');
  return line;
}

function drawPlots() {
  document.getElementById('plots').replaceChildren();
  groups.forEach(drawGroup);
  document.getElementById('plots').append(legend());
}

function choose(k, event) {
  if (event) event.preventDefault();
  chosen = k;
  describe(k);
  film = null;
  document.getElementById('film').hidden = true;
  if (hasFilm(k)) play(k);
}
)js"
                                R"js(
// Films.
const films = data.films;
const hasFilm = k => films !== null && films.points[k].frames !== '';
const canvas = document.getElementById('canvas');
const seek = document.getElementById('seek');
const hold = 60;  // pictures at the greatest error
let film = null;

function framesOf(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const numbers = new Int16Array(bytes.buffer, 0, bytes.length >> 1);
  const frames = [];
  let next = 0;
  const place = () => [films.origin[0] + films.unit * numbers[next++], films.origin[1] + films.unit * numbers[next++]];
  while (next < numbers.length) {
    const frame = {cords: [], bodies: []};
    for (let c = numbers[next++]; c > 0; --c) {
      const cord = [];
      for (let n = numbers[next++]; n > 0; --n) cord.push(place());
      frame.cords.push(cord);
    }
    for (let n = numbers[next++]; n > 0; --n) frame.bodies.push(place());
    frames.push(frame);
  }
  return frames;
}
let reference = null;

function color(name) { return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim(); }

/// Draws a view: its middle and width in metres, in a rectangle of the canvas.
function drawView(context, view, frames, greatest) {
  const scale = view.w / view.metres;
  const at = p => [view.x + 0.5 * view.w + scale * (p[0] - view.middle[0]),
                   view.y + 0.5 * view.h - scale * (p[1] - view.middle[1])];
  context.save();
  context.beginPath();
  context.rect(view.x, view.y, view.w, view.h);
  context.clip();
  context.fillStyle = color('paper');
  context.fillRect(view.x, view.y, view.w, view.h);
  context.fillStyle = color('ground');
  for (const outline of films.scenery) {
    context.beginPath();
    outline.forEach(p => context.lineTo(...at(p)));
    context.fill();
  }
  for (const [frame, name, thickness] of [[frames[0], 'reference', 4], [frames[1], 'setting', 1.8]]) {
    if (!frame) continue;
    context.strokeStyle = context.fillStyle = color(name);
    context.lineWidth = thickness;
    for (const cord of frame.cords) {
      context.beginPath();
      cord.forEach(p => context.lineTo(...at(p)));
      context.stroke();
    }
    frame.bodies.forEach((p, k) => {
      context.beginPath();
      context.arc(...at(p), k === 0 ? 6 : 4, 0, 7);
      name === 'reference' ? context.fill() : context.stroke();
    });
  }
  if (greatest) {
    context.strokeStyle = color('bad');
    context.lineWidth = 2;
    context.beginPath();
    context.arc(...at(greatest.place), 14, 0, 7);
    context.moveTo(...at(greatest.place));
    context.lineTo(...at(greatest.reference));
    context.stroke();
  }
  context.restore();
}

function bar(context, x, y, scale, metres, label) {
  context.strokeStyle = context.fillStyle = color('ink');
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + metres * scale, y);
  context.stroke();
  context.fillText(label, x, y - 5);
}

function drawFilm() {
  if (!film) return;
  const ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = Math.round(0.62 * w);
  canvas.width = w * ratio;
  canvas.height = h * ratio;
  canvas.style.height = h + 'px';
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.font = '13px sans-serif';
  const k = Math.floor(film.at);
  const now = reference[Math.min(k, reference.length - 1)];
  const greatest = film.greatest.tick > 0 ? film.greatest : null;
  const atGreatest = greatest && k === film.worst;
  const metres = 12;
  drawView(context, {x: 0, y: 0, w, h, metres, middle: atGreatest ? greatest.place : now.bodies[0]},
           [now, film.frames[k]], atGreatest && greatest);
  bar(context, 10, h - 10, w / metres, 1, '1 m');
  if (greatest) {
    const size = Math.min(0.42 * w, 190), wide = Math.max(0.1, 3 * greatest.metres);
    const view = {x: w - size - 6, y: 6, w: size, h: size, metres: wide,
                  middle: greatest.place.map((v, a) => 0.5 * (v + greatest.reference[a]))};
    drawView(context, view, [reference[Math.min(film.worst, reference.length - 1)], film.frames[film.worst]], greatest);
    context.strokeStyle = color('soft');
    context.strokeRect(view.x, view.y, size, size);
    bar(context, view.x + 8, size - 4, size / wide, 0.01, '1 cm');
    context.fillText('greatest error ' + digits(100 * greatest.metres) + ' cm', view.x + 8, view.y + 16);
  }
  document.getElementById('time').textContent =
      (k * films.ticksPerFrame / 60).toFixed(2) + ' s' + (atGreatest ? ': greatest error' : '') +
      (k * films.ticksPerFrame > films.compared ? ': no longer compared' : '');
  seek.value = k;
}

function play(k, from) {
  reference ??= framesOf(films.converged);
  const frames = framesOf(films.points[k].frames), greatest = films.points[k].greatest;
  const worst = Math.min(frames.length - 1, Math.round(Math.max(0, greatest.tick - 1) / films.ticksPerFrame));
  film = {point: k, frames, greatest, worst, at: from ?? 0, held: 0, runs: from === undefined, last: 0};
  document.getElementById('film').hidden = false;
  document.getElementById('film').dataset.point = k;
  seek.max = frames.length - 1;
  button();
  nextFrame();
}
let pending = 0;
function nextFrame() {
  cancelAnimationFrame(pending);
  pending = requestAnimationFrame(step);
}
function button() { document.getElementById('play').textContent = film && film.runs ? 'pause' : 'play'; }
function step(time) {
  if (!film) return;
  const passed = film.last ? Math.min(0.1, (time - film.last) / 1000) : 0;
  film.last = time;
  if (film.runs) {
    const before = Math.floor(film.at);
    if (before === film.worst && film.greatest.tick > 0 && film.held < hold) {
      ++film.held;
    } else {
      film.at += passed * 60 / films.ticksPerFrame;
      if (before < film.worst && film.at > film.worst) film.at = film.worst;
    }
    if (film.at >= film.frames.length - 1) { film.at = film.frames.length - 1; film.runs = false; button(); }
  }
  drawFilm();
  if (film.runs) nextFrame();
}
function stopAt(frame) {
  if (!film) return;
  film.runs = false;
  film.at = frame;
  button();
  drawFilm();
}
document.getElementById('play').addEventListener('click', () => {
  if (!film) return;
  film.runs = !film.runs;
  film.last = 0;
  if (film.runs && film.at >= film.frames.length - 1) { film.at = 0; film.held = 0; }
  button();
  nextFrame();
});
document.getElementById('worst').addEventListener('click', () => film && stopAt(film.worst));
seek.addEventListener('input', () => stopAt(Number(seek.value)));
for (const show of document.querySelectorAll('button.show')) {
  const k = Number(show.dataset.point);
  if (!hasFilm(k)) continue;
  show.hidden = false;
  show.addEventListener('click', () => {
    choose(k);
    const tick = /in tick (\d+)/.exec(data.points[k].failure);
    if (tick) stopAt(Math.min(film.frames.length - 1, Math.floor((tick[1] - 1) / films.ticksPerFrame)));
    document.getElementById('film').scrollIntoView({block: 'center'});
  });
}
addEventListener('resize', () => { drawPlots(); drawFilm(); });
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawFilm);
drawPlots();
describe(chosen);
)js";

}  // namespace study
