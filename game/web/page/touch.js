// Touch as keys and mouse. The left half is a stick: run, swing and climb. On the right are buttons to jump and to catch;
// a touch anywhere else is a click there, which throws a line in a level and chooses in a menu. Where the layer is plain,
// as in the lab, a finger is a mouse everywhere.
'use strict';

const startTouch = (layer, canvas) => {
  const stickSize = 24;  // px from where the finger came down
  const keyCodes = {KeyA: 65, KeyD: 68, KeyW: 87, KeyS: 83, Space: 32, KeyE: 69, Escape: 27};
  const held = new Set();
  const setKey = (code, down) => {
    if (held.has(code) === down) return;
    if (down) held.add(code); else held.delete(code);
    const key = code === 'Space' ? ' ' : code === 'Escape' ? code : code.at(-1).toLowerCase();
    const event = new KeyboardEvent(down ? 'keydown' : 'keyup', {code, key, keyCode: keyCodes[code], bubbles: true});
    window.dispatchEvent(event);
  };
  const click = (type, touch) => canvas.dispatchEvent(new MouseEvent(type, {
    clientX: touch.clientX, clientY: touch.clientY, button: 0, buttons: type === 'mouseup' ? 0 : 1, bubbles: true}));

  const buttons = [['Jump', 'Space', 24, 24], ['Catch', 'KeyE', 120, 24], ['Pause', 'Escape', 24, null]];
  const pads = new Map();
  for (const [name, code, right, bottom] of buttons) {
    const pad = document.createElement('div');
    pad.className = 'pad';
    pad.textContent = name;
    pad.style.right = right + 'px';
    if (bottom === null) pad.style.top = '64px'; else pad.style.bottom = bottom + 'px';
    layer.append(pad);
    pads.set(pad, code);
  }

  const touches = new Map();
  const stick = (dx, dy) => {
    setKey('KeyA', dx < -stickSize);
    setKey('KeyD', dx > stickSize);
    setKey('KeyW', dy < -stickSize);
    setKey('KeyS', dy > stickSize);
  };
  const on = (name, act) => layer.addEventListener(name, event => {
    event.preventDefault();
    for (const touch of event.changedTouches) act(touch, event);
  }, {passive: false});
  on('touchstart', (touch, event) => {
    canvas.focus();
    if (pads.has(event.target) && event.targetTouches.length > 0) {
      touches.set(touch.identifier, {code: pads.get(touch.target)});
      return setKey(pads.get(touch.target), true);
    }
    const left = !layer.classList.contains('plain') && touch.clientX < innerWidth / 2;
    touches.set(touch.identifier, {x: touch.clientX, y: touch.clientY, left, moved: false});
    click('mousemove', touch);
    if (!left) click('mousedown', touch);
  });
  on('touchmove', touch => {
    const from = touches.get(touch.identifier);
    if (!from || from.code) return;
    if (!from.left) return click('mousemove', touch);
    const dx = touch.clientX - from.x, dy = touch.clientY - from.y;
    from.moved ||= Math.hypot(dx, dy) > stickSize;
    stick(dx, dy);
  });
  const end = touch => {
    const from = touches.get(touch.identifier);
    touches.delete(touch.identifier);
    if (!from) return;
    if (from.code) return setKey(from.code, false);
    if (from.left) {
      stick(0, 0);
      if (!from.moved) click('mousedown', touch);
    }
    click('mouseup', touch);
  };
  on('touchend', end);
  on('touchcancel', end);
};
