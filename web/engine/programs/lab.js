// A program inside of a page that shows it, as the lab does: messages in both directions. It stands
// in a frame without the page's origin, so neither can reach into the other.
(() => {
  if (parent === self) return;
  document.documentElement.dataset.inside = '';
  const tell = (message, transfer = []) =>
    parent.postMessage({ gw: 'program', ...message }, '*', transfer);

  addEventListener('gw-program', ({ detail }) =>
    tell(detail, detail.bytes ? [detail.bytes.buffer] : []),
  );
  const margin = 3; // of page.html
  new ResizeObserver(() => {
    const { height } = document.body.getBoundingClientRect();
    tell({ what: 'size', height: Math.ceil(height) + 2 * margin });
  }).observe(document.body);

  const doings = {
    look({ language, dark }) {
      document.documentElement.dataset.theme = dark ? 'dark' : 'light';
      Module.screen.say(language);
    },
    key: (event) => Module.screen.press(event),
    menu: ({ entry }) => Module.screen.menu(entry),
    record({ frames }) {
      if (Module._gw_record?.(frames) !== 1) tell({ what: 'refused' });
    },
  };
  addEventListener('message', (event) => {
    if (event.source === parent && event.data?.gw === 'lab') doings[event.data.what]?.(event.data);
  });
  tell({ what: 'begun' });
})();
