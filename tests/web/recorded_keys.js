// The keys of a recorded run of one player: which are down, and for how many ticks. engine/replay/replay.h describes the
// file, game/simulation/buttons.h the buttons, and game/settings/bindings.cpp their keys.
'use strict';

const keys = ['KeyA', 'KeyD', 'Space', 'KeyE', null, null, 'KeyW', 'KeyS', 'KeyF', 'KeyQ', 'KeyZ', 'KeyT', 'KeyC', 'KeyG', 'KeyV'];

const inputsOf = file => {
  const buttons = [];
  for (let at = file.indexOf(10, file.indexOf(10) + 1) + 5; file[at] === 0x54;) {
    buttons.push(file.readUInt16LE(at + 5));
    at += 5 + 6 + file.readUInt16LE(at + 1) * 7 + 12;
  }
  return buttons;
};

// Returns [{down: codes, up: codes, ticks}, …].
const keysOf = file => {
  const parts = [];
  let before = 0;
  for (const now of inputsOf(file)) {
    if (now !== before || parts.length === 0) {
      const of = bits => keys.filter((_, bit) => bits >> bit & 1);
      const part = {down: of(now & ~before), up: of(before & ~now), ticks: 0};
      if ([...part.down, ...part.up].includes(null)) throw new Error('a button of the recording has no key here');
      parts.push(part);
      before = now;
    }
    ++parts.at(-1).ticks;
  }
  return parts;
};

module.exports = {inputsOf, keysOf};
