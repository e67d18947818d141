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

  function listen(window) {
    const { canvas } = window;
    const key = (down) => (event) => {
      if (event.metaKey || (event.ctrlKey && !event.altKey && event.key.length === 1)) return;
      if (event.key === 'Tab') return; // leaves the window
      event.preventDefault();
      if (down && event.repeat) return;
      add(window, Key, event.code, [Number(down), down ? character(event) : 0, 0, 0]);
    };
    const button = (down) => (event) => {
      if (down) {
        canvas.focus();
        canvas.setPointerCapture(event.pointerId);
      }
      add(window, Button, '', [Number(down), event.button, ...point(window, event)]);
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
      close.title = close.ariaLabel = 'Close';
      Object.assign(canvas, { width, height, tabIndex: 0 });
      canvas.setAttribute('role', 'application');
      caption.append(name, close);
      figure.append(caption, canvas);
      place.append(figure);
      const window = { figure, name, canvas, events: [] };
      windows.set(next, window);
      close.addEventListener('click', () => add(window, Close, '', [0, 0, 0, 0]));
      listen(window);
      this.name(next, title);
      if (windows.size === 1) canvas.focus();
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
    /** Whether the program must let the browser work before it goes on. */
    mustTurn(milliseconds) {
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
      state.textContent = status === 0 ? 'The program has ended.' : `It ended with ${status}.`;
      document.body.dataset.status = String(status);
      showFiles();
    },
    onAbort(what) {
      state.textContent = `The program was stopped: ${what}`;
      document.body.dataset.status = 'abort';
    },
    onRuntimeInitialized() {
      state.textContent = '';
    },
  });
})();
