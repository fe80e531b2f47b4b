// ---- input: keys, pointers, wheel ----

const ClickDistance = 5;

function listenToStage(stage, app) {
  const { canvas, camera } = stage;
  const pointers = new Map();
  let moved = 0;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
    moved = pointers.size > 1 ? Infinity : 0;
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) {
      return;
    }

    const now = at(event);
    if (pointers.size === 1) {
      moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
      if (moved > ClickDistance) {
        camera.pan(now[0] - before[0], now[1] - before[1]);
      }
    } else {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
      const is = Math.hypot(now[0] - other[0], now[1] - other[1]);
      camera.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
      camera.zoom(was > 0 ? is / was : 1, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2, stage.width, stage.height);
    }

    pointers.set(event.pointerId, now);
    app.redraw();
  });
  const up = (event) => {
    if (pointers.delete(event.pointerId) && event.type === 'pointerup' && moved <= ClickDistance) {
      app.pick(stage.pickAt(...at(event), app.view));
    }
  };
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : 1;
    camera.zoom(Math.exp(-event.deltaY * unit * 0.0015), ...at(event), stage.width, stage.height);
    app.redraw();
  }, { passive: false });
  canvas.addEventListener('dblclick', () => app.center());
}

// Keys that say the same wherever the focus is, but not while something is typed.
function listenToKeys(app) {
  document.addEventListener('keydown', (event) => {
    if (byId('help').open || event.ctrlKey || event.metaKey) {
      return;
    }

    if (event.altKey) {
      if (moveByKey(event, app)) {
        event.preventDefault();
      }

      return;
    }

    const { target } = event;
    const isTyping = target.matches('input:not([type="range"]), select, textarea');
    if (isTyping) {
      if (event.key === 'Escape') {
        target.blur();
      }

      return;
    }

    const isButton = target.matches('button') && (event.key === ' ' || event.key === 'Enter');
    const isTab = target.matches('[role="tab"]') && event.key.startsWith('Arrow');
    const isToolbar = target.matches('#scrub') && (event.key.startsWith('Arrow') || event.key.startsWith('Page') || event.key === 'Home'
      || event.key === 'End');
    const action = app.keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (action && !isButton && !isTab && !isToolbar) {
      event.preventDefault();
      action(event);
    }
  });
}

function moveByKey(event, app) {
  const stage = app.stages[0];
  const step = 60;
  const moves = { ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
  if (moves[event.key]) {
    app.camera.pan(...moves[event.key]);
  } else if (event.key === '+' || event.key === '=') {
    app.camera.zoom(1.25, stage.width / 2, stage.height / 2, stage.width, stage.height);
  } else if (event.key === '-') {
    app.camera.zoom(0.8, stage.width / 2, stage.height / 2, stage.width, stage.height);
  } else {
    return false;
  }

  app.redraw();
  return true;
}

function listenToTabs(app) {
  const tabs = [...document.querySelectorAll('[role="tab"]')];
  tabs.forEach((tab, i) => {
    tab.addEventListener('click', () => app.openTab(tab.id.slice(4)));
    tab.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (step) {
        const next = tabs[(i + step + tabs.length) % tabs.length];
        next.focus();
        app.openTab(next.id.slice(4));
      }
    });
  });
}
