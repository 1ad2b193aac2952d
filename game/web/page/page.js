// Starts the game in the page: its files, its storage, what a link asks for, and what a browser needs besides.
'use strict';

const at = id => document.getElementById(id);
const runs = '/user/data/ropeswing/runs';
const pictures = '/user/pictures';

const say = (sentence, ...choices) => {
  at('message').hidden = false;
  at('sentence').textContent = sentence;
  at('choices').replaceChildren(...choices.map(([text, act]) => {
    const button = document.createElement('button');
    button.textContent = text;
    button.onclick = act;
    return button;
  }));
};
const startAt = hash => {
  history.replaceState(null, '', location.pathname + location.search + hash);
  location.reload();
};
const fromTitle = ['Start from the title', () => startAt('')];

const download = (name, bytes) => {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

// Whether the browser lets the page store anything: private windows may not.
const canStore = () => new Promise(resolve => {
  try {
    const probe = indexedDB.open('ropeswing-probe');
    probe.onsuccess = () => { probe.result.close(); resolve(true); };
    probe.onerror = () => resolve(false);
    probe.onblocked = () => resolve(false);
  } catch {
    resolve(false);
  }
});

// The user's files: settings, times and recordings. They are read before the game starts and stored as it goes on.
let stores = false, storing = false;
const store = () => {
  if (!stores || storing) return;
  storing = true;
  Module.FS.syncfs(false, error => {
    storing = false;
    if (error) stores = false;
  });
};
const openStorage = () => {
  Module.FS.mkdirTree('/user');
  Object.assign(Module.ENV, {HOME: '/user', XDG_CONFIG_HOME: '/user/config', XDG_DATA_HOME: '/user/data',
    XDG_PICTURES_DIR: pictures});
  if (!stores) return;
  Module.FS.mount(Module.IDBFS, {}, '/user');
  Module.addRunDependency('storage');
  Module.FS.syncfs(true, error => {
    stores = !error;
    Module.removeRunDependency('storage');
  });
};

const filesIn = folder => (Module.FS.analyzePath(folder).exists ? Module.FS.readdir(folder).filter(n => n[0] !== '.') : []);
const lastRun = () => {
  const names = filesIn(runs).filter(name => name.endsWith('.replay')).sort();
  return names.length ? {name: names.at(-1), bytes: Module.FS.readFile(runs + '/' + names.at(-1))} : null;
};
const withLastRun = act => () => {
  const run = lastRun();
  if (run) act(run); else tell('There is no run to share yet: play a level first.');
  at('canvas').focus();
};
const tell = text => {
  const note = document.createElement('div');
  note.className = 'button';
  note.textContent = text;
  at('bar').prepend(note);
  setTimeout(() => note.remove(), 5000);
};

// A link that the page cannot put into the clipboard, selected, so that two keys copy it. Keys there are not the game's.
const showLink = link => {
  at('shown').hidden = false;
  at('run').value = link;
  at('run').select();
};
const hideLink = () => {
  at('shown').hidden = true;
  at('canvas').focus();
};
const startShown = () => {
  at('shown').onsubmit = event => {
    event.preventDefault();
    hideLink();
  };
  for (const name of ['keydown', 'keypress', 'keyup']) at('shown').addEventListener(name, event => event.stopPropagation());
  at('shown').addEventListener('keydown', event => { if (event.key === 'Escape') hideLink(); });
};

const maxLink = 60000;  // letters; some programs cut longer links
const startBar = () => {
  at('bar').hidden = false;
  at('save').onclick = withLastRun(run => download(run.name, run.bytes));
  at('link').onclick = withLastRun(async run => {
    const link = location.origin + location.pathname + '#replay=' + await Recording.toLink(run.bytes);
    if (link.length > maxLink) return tell('This run is too long for a link: download it.');
    try {
      await navigator.clipboard.writeText(link);
      tell('The link is in the clipboard.');
    } catch {
      showLink(link);
    }
  });
  at('open').onchange = async event => {
    const bytes = new Uint8Array(await event.target.files[0].arrayBuffer());
    const file = btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''));
    try {
      sessionStorage.setItem('opened', file);
    } catch {
      return tell('The browser does not let the page keep this recording.');
    }
    startAt('#opened');
  };
};

// Screenshots of the game become downloads.
const takePictures = () => {
  for (const name of filesIn(pictures)) {
    download(name, Module.FS.readFile(pictures + '/' + name));
    Module.FS.unlink(pictures + '/' + name);
  }
};

// What the link asks for, as arguments of the game; recordings become a file, whose name is in the game's sentences.
const replayOf = (name, bytes) => ({arguments: ['replay', name], file: {name, bytes}});
const wanted = async () => {
  const [, name, value] = location.hash.match(/^#(level|lab|replay|opened)(?:=(.*))?$/) ?? [];
  if (name === 'level' || name === 'lab') return {arguments: [name, decodeURIComponent(value ?? '')]};
  if (name === 'replay') return replayOf('the link', await Recording.fromLink(value ?? ''));
  const opened = name === 'opened' && sessionStorage.getItem('opened');
  if (!opened) return {arguments: []};
  return replayOf('the recording', Uint8Array.from(atob(opened), c => c.charCodeAt(0)));
};

const mixerContext = () => Module.SDL2?.audioContext;

var Module = {
  canvas: at('canvas'),
  gameEnded(sentence) {
    store();
    say(sentence || 'The game has ended.', fromTitle);
  },
  gameShown() {
    at('message').hidden = true;
    performance.mark('first frame');
    startBar();
    startShown();
    setInterval(() => { store(); takePictures(); }, 2000);
    at('canvas').focus();
  },
  // In the lab a finger is a mouse everywhere: there are no buttons to run and to jump, and no recording to share.
  gameFingers(asMouse) {
    at('touch').classList.toggle('plain', asMouse);
    at('bar').classList.toggle('plain', asMouse);
  },
  onAbort(reason) {
    say('The game has stopped: ' + reason, fromTitle);
  },
};

const watchBrowser = () => {
  // A page in the background gets no frames. The game pauses when the window loses the focus, so it is told of that.
  document.addEventListener('visibilitychange', () => {
    window.dispatchEvent(new FocusEvent(document.hidden ? 'blur' : 'focus'));
    if (document.hidden) {
      store();
      mixerContext()?.suspend();
    } else {
      mixerContext()?.resume();
    }
  });
  // A browser lets a page sound once a gesture has ended; a finger on the glass is not one yet.
  for (const gesture of ['keydown', 'pointerup', 'touchend']) {
    addEventListener(gesture, () => { if (mixerContext()?.state === 'suspended') mixerContext().resume(); }, true);
  }
  at('canvas').addEventListener('webglcontextlost', event => event.preventDefault());
  at('canvas').addEventListener('webglcontextrestored', () => Module._renew_window());
  addEventListener('pagehide', store);
  addEventListener('hashchange', () => location.reload());
  addEventListener('touchstart', () => {
    if (!at('touch').hidden) return;
    at('touch').hidden = false;
    startTouch(at('touch'), at('canvas'));
  }, {once: true});
};

const start = async () => {
  if (typeof WebAssembly !== 'object') {
    return say('This browser does not run WebAssembly, which the game needs. Any browser since 2023 does.');
  }
  stores = await canStore();
  const asked = await wanted();
  Module.arguments = asked.arguments;
  Module.preRun = [openStorage, () => { if (asked.file) Module.FS.writeFile(asked.file.name, asked.file.bytes); }];
  watchBrowser();
  const script = document.createElement('script');
  script.src = 'game.js';
  script.onerror = () => say('The game could not be loaded. Look at your connection and load the page again.');
  document.body.append(script);
};
start();
