// The screen of a program: windows as canvases, what the user does in them, and what the program
// leaves behind. browser_window.cpp calls Module.screen.
(() => {
  const Key = 1,
    Button = 2,
    Pointer = 3,
    Focus = 4,
    Close = 5; // browser_window.cpp
  const frameTime = 12,
    hiddenFrameTime = 250; // milliseconds
  const place = document.querySelector('#windows');
  const said = document.querySelector('#said');
  const state = document.querySelector('#state');
  const windows = new Map();
  let next = 1;
  let isShown = false; // since the last turn
  let lastTurn = 0;
  let wake = () => {};
  /** Tells lab.js what has happened. */
  const tell = (what, more = {}) =>
    dispatchEvent(new CustomEvent('gw-program', { detail: { what, ...more } }));

  const words = {
    en: {
      loading: 'The program is loading.',
      running: '',
      ended: 'The program has ended.',
      failed: 'It ended with {0}.',
      stopped: 'The program was stopped: {0}',
      close: 'Close',
      said: 'What the program says',
    },
    ja: {
      loading: 'プログラムを読み込んでいます。',
      running: '',
      ended: 'プログラムは終わりました。',
      failed: '終了コード {0} で終わりました。',
      stopped: 'プログラムが止まりました：{0}',
      close: '閉じる',
      said: 'プログラムの出力',
    },
  };
  const word = (name, value) =>
    (words[document.documentElement.lang] ?? words.en)[name].replace('{0}', value);
  let now = ['loading'];
  function showState(...named) {
    now = named;
    state.textContent = word(...named);
  }

  const characters = {
    Enter: 13,
    Backspace: 8,
    Escape: 27,
    Delete: 127,
  };
  const character = (event) =>
    event.key.length === 1 ? event.key.charCodeAt(0) & 255 : (characters[event.key] ?? 0);

  function add(window, kind, code, values) {
    const last = window.events.at(-1);
    if (kind === Button || kind === Pointer) window.pointer = values.slice(2);
    if (kind === Pointer && last?.kind === Pointer) window.events.pop(); // the newest counts
    window.events.push({ kind, code, values });
    wake();
  }
  const point = ({ canvas }, event) => {
    const box = canvas.getBoundingClientRect();
    const scale = (at, size, pixels) =>
      Math.min(pixels - 1, Math.max(0, Math.floor((at * pixels) / size)));
    return [
      scale(event.clientX - box.left, box.width, canvas.width),
      canvas.height - 1 - scale(event.clientY - box.top, box.height, canvas.height),
    ];
  };

  /** The right button, by keys or for a finger: it stays down until the menu's choice. */
  function holdMenu(window, at) {
    window.holdsMenu = true;
    add(window, Button, '', [1, 2, ...at]);
  }
  /** Up again: where it was, or outside of every entry. */
  function releaseMenu(window, at = window.pointer) {
    if (!window.holdsMenu) return;
    window.holdsMenu = false;
    add(window, Button, '', [0, 2, ...at]);
  }
  const outside = [-1, -1];
  const menuPlace = ({ canvas }) => [
    Math.floor(canvas.width / 4),
    Math.floor((canvas.height * 3) / 4),
  ];
  const strike = (window, event) => {
    add(window, Key, event.code, [1, character(event), 0, 0]);
    add(window, Key, event.code, [0, 0, 0, 0]);
  };
  /** Keys that wait until the program waits for events: its menu is open. */
  let later = [];
  function strikeLater() {
    for (const { window, event } of later) strike(window, event);
    for (const { window } of later.splice(0, Infinity)) releaseMenu(window);
  }

  function listen(window) {
    const { canvas } = window;
    const key = (down) => (event) => {
      if (event.metaKey || (event.ctrlKey && !event.altKey && event.key.length === 1)) return;
      if (event.key === 'Tab') return; // leaves the window
      event.preventDefault();
      if (down && event.repeat) return;
      if (event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey)) {
        if (down && !window.holdsMenu) holdMenu(window, menuPlace(window));
        return;
      }
      if (event.key === 'Escape' && window.holdsMenu) {
        if (!down) releaseMenu(window, outside); // the program's own Escape may be its end
        return;
      }
      add(window, Key, event.code, [Number(down), down ? character(event) : 0, 0, 0]);
      if (event.key === 'Enter' && !down) releaseMenu(window);
    };
    const button = (down) => (event) => {
      if (down) {
        canvas.focus();
        canvas.setPointerCapture(event.pointerId);
      }
      add(window, Button, '', [Number(down), event.button, ...point(window, event)]);
      if (!down) releaseMenu(window);
    };
    canvas.addEventListener('keydown', key(true));
    canvas.addEventListener('keyup', key(false));
    canvas.addEventListener('pointerdown', button(true));
    canvas.addEventListener('pointerup', button(false));
    canvas.addEventListener('pointermove', (event) =>
      add(window, Pointer, '', [0, 0, ...point(window, event)]),
    );
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('focus', () => add(window, Focus, '', [0, 0, 0, 0]));
  }

  /** RGBA, bottom row first. */
  function paint(canvas, pixels) {
    const { width, height } = canvas;
    const image = new ImageData(width, height);
    for (let row = 0; row < height; ++row)
      image.data.set(
        pixels.subarray(4 * width * row, 4 * width * (row + 1)),
        4 * width * (height - 1 - row),
      );
    canvas.getContext('2d').putImageData(image, 0, 0);
  }

  const screen = {
    open(title, x, y, width, height) {
      const figure = document.createElement('figure');
      const caption = document.createElement('figcaption');
      const name = document.createElement('span');
      const close = document.createElement('button');
      const canvas = document.createElement('canvas');
      close.textContent = '\u00d7';
      close.className = 'close';
      close.title = close.ariaLabel = word('close');
      Object.assign(canvas, { width, height, tabIndex: 0 });
      canvas.setAttribute('role', 'application');
      caption.append(name, close);
      figure.append(caption, canvas);
      place.append(figure);
      const window = { figure, name, canvas, events: [], pointer: [0, 0], holdsMenu: false };
      windows.set(next, window);
      close.addEventListener('click', () => add(window, Close, '', [0, 0, 0, 0]));
      listen(window);
      this.name(next, title);
      if (windows.size === 1 && parent === self) canvas.focus();
      return next++;
    },
    close(id) {
      windows.get(id).figure.remove();
      windows.delete(id);
    },
    name(id, title) {
      const { name, canvas } = windows.get(id);
      name.textContent = title;
      canvas.ariaLabel = title;
    },
    cursor(id, on) {
      windows.get(id).canvas.style.cursor = on ? '' : 'none';
    },
    /** Of RGBA, bottom row first, and the place that points; of size 0: a cross. */
    cursorImage(id, pixels, size, x, y) {
      const { style } = windows.get(id).canvas;
      if (size === 0) return (style.cursor = 'crosshair');
      const canvas = Object.assign(document.createElement('canvas'), {
        width: size,
        height: size,
      });
      paint(canvas, pixels);
      style.cursor = `url(${canvas.toDataURL()}) ${x} ${size - 1 - y}, auto`;
    },
    ring() {
      document.body.animate([{ filter: 'invert(1)' }, {}], 100);
    },
    show(id, pixels, width, height) {
      const { canvas } = windows.get(id);
      if (canvas.width !== width || canvas.height !== height)
        Object.assign(canvas, { width, height });
      paint(canvas, pixels);
      isShown = true;
    },
    take(id) {
      return windows.get(id).events.shift();
    },
    /** A key of {code, key}, in the first window. */
    press(event) {
      const [window] = windows.values();
      if (window) strike(window, event);
    },
    /** The menu of the first window; its entry of this number is chosen. 0: it stays open. */
    menu(entry) {
      const [window] = windows.values();
      if (!window || window.holdsMenu) return;
      holdMenu(window, menuPlace(window));
      if (entry === 0) window.canvas.focus();
      const down = { window, event: { code: 'ArrowDown', key: 'ArrowDown' } };
      if (entry > 0)
        later = [...Array(entry).fill(down), { window, event: { code: 'Enter', key: 'Enter' } }];
    },
    /** page_recorder.cpp: a recording is ready. */
    recorded(file) {
      tell('recorded', { bytes: FS.readFile(file) });
    },
    /** In another language. */
    say(language) {
      document.documentElement.lang = language;
      for (const button of document.querySelectorAll('.close'))
        button.title = button.ariaLabel = word('close');
      said.ariaLabel = word('said');
      showState(...now);
    },
    /** Whether the program must let the browser work before it goes on. */
    mustTurn(milliseconds) {
      const [window] = windows.values();
      if (milliseconds > 0 && later.length && !window.events.length) strikeLater();
      return milliseconds > 0 || isShown || performance.now() - lastTurn > frameTime;
    },
    /** A picture is on the screen, an event is there, or the time is over. */
    async turn(milliseconds) {
      if (isShown)
        await new Promise((done) => {
          requestAnimationFrame(done);
          setTimeout(done, hiddenFrameTime);
        });
      else if (milliseconds > 0 && [...windows.values()].every(({ events }) => !events.length))
        await new Promise((done) => {
          wake = done;
          setTimeout(done, milliseconds);
        });
      else await new Promise((done) => setTimeout(done, 0));
      isShown = false;
      lastTurn = performance.now();
    },
  };

  /** A picture that a program has written: PPM of 8 bits. */
  function portablePixmap(bytes) {
    const head = /^P6\s+(?:#.*\n)?(\d+)\s+(\d+)\s+255\s/.exec(
      new TextDecoder('latin1').decode(bytes.subarray(0, 100)),
    );
    if (!head) return undefined;
    const [width, height] = [Number(head[1]), Number(head[2])];
    const canvas = Object.assign(document.createElement('canvas'), {
      width,
      height,
    });
    const image = new ImageData(width, height);
    const rgb = bytes.subarray(head[0].length);
    for (let i = 0; i < width * height; ++i)
      image.data.set([rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255], 4 * i);
    canvas.getContext('2d').putImageData(image, 0, 0);
    return canvas;
  }

  let before = new Set();
  const files = () => FS.readdir('.').filter((name) => FS.isFile(FS.stat(name).mode));
  function showFiles() {
    for (const name of files().filter((each) => !before.has(each))) {
      const bytes = FS.readFile(name);
      const figure = document.createElement('figure');
      const link = document.createElement('a');
      Object.assign(link, { textContent: name, download: name });
      link.href = URL.createObjectURL(new Blob([bytes]));
      figure.append(link);
      const picture = portablePixmap(bytes);
      if (picture) figure.append(picture);
      place.append(figure);
    }
  }

  // exit() after a turn of the browser ends in a promise that nobody waits for.
  addEventListener('unhandledrejection', (event) => {
    if (event.reason?.name === 'ExitStatus') event.preventDefault();
  });

  const say = (text) => {
    said.textContent += `${text}\n`;
    said.scrollTop = said.scrollHeight;
  };
  const asked = new URLSearchParams(location.search);
  Object.assign(Module, {
    screen,
    print: say,
    printErr: say,
    thisProgram: decodeURIComponent(location.pathname.split('/').at(-1)).replace(/\.html$/, ''),
    arguments: asked.getAll('arg'),
    preRun: [
      () => {
        for (const [name, value] of asked) if (name.startsWith('GW_')) ENV[name] = value;
        before = new Set(files());
      },
    ],
    onExit(status) {
      showState(status === 0 ? 'ended' : 'failed', status);
      document.body.dataset.status = String(status);
      showFiles();
      tell('ended', { status });
    },
    onAbort(what) {
      showState('stopped', what);
      document.body.dataset.status = 'abort';
      tell('ended', { status: -1 });
    },
    onRuntimeInitialized() {
      showState('running');
      tell('running');
    },
  });
})();
