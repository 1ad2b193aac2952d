// The time of a page in the hands of a test: frames come when it says, and each lasts as long as it says. So keys that are
// pressed between two frames arrive at the tick of the game that they are meant for, however slow the machine is.
'use strict';

const inPage = () => {
  let now = 0;
  let waiting = [];
  performance.now = () => now;
  window.requestAnimationFrame = frame => waiting.push(frame);
  window.clock = {
    waits: () => waiting.length > 0,
    run(frames, ms) {
      for (; frames > 0; --frames) {
        now += ms;
        const due = waiting;
        waiting = [];
        for (const frame of due) frame(now);
      }
    },
  };
};

module.exports = {source: `(${inPage})()`, tick: 1000 / 60};
