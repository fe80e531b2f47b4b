// ---- main: puts the parts together ----

class App {
  constructor() {
    this.recordings = [];
    this.frame = 0;
    this.isDrawn = false;
    this.needsDrawing = true;
    this.view = { coloring: 'state', contacts: true, links: true, picked: null, difference: null };
    this.tab = 'inspect';
    this.lastTold = 0;
  }

  async open() {
    for (let number = 0; byId(`run-${number}`); number++) {
      const data = byId(`data-${number}`);
      const recording = new Recording(JSON.parse(byId(`run-${number}`).textContent), data.textContent, number);
      data.remove();
      await recording.open();
      this.recordings.push(recording);
    }

    this.frames = Math.max(...this.recordings.map((recording) => recording.frames));
    this.longest = this.recordings.find((recording) => recording.frames === this.frames);
    readPalette();
    const [first] = this.recordings;
    this.camera = new Camera(first.meta.yUp);
    const two = this.recordings.length > 1;
    this.stages = this.recordings.map((recording, i) => {
      const name = two ? `${i === 0 ? 'First' : 'Second'}: ${recording.meta.title}` : '';
      return new Stage(recording, this.camera, name || recording.meta.title);
    });
    this.stages.forEach((stage) => {
      if (!two) {
        stage.element.querySelector('.name').hidden = true;
      }

      byId('stages').append(stage.element);
      listenToStage(stage, this);
    });
    this.timeline = new Timeline(byId('timeline'), first, (frame) => this.seek(frame));
    this.inspector = new Inspector(byId('panel-inspect'), this);
    this.report = new Report(byId('panel-report'), this);
    this.eventList = new EventList(byId('panel-events'), this);
    this.search = new Search(byId('panel-find'), this);
    this.player = new Player(this);
    byId('summary').textContent = [
      countText(first.meta.bodyCount, 'body', 'bodies'), countText(first.frames, 'update', 'updates'), `numbers: ${precisionText(first)}`,
    ].join(' \u00b7 ');
    this.bind();
    this.showDifference();
    this.report.build();
    this.search.build();
    this.inspector.reset();
    this.fit();
    this.show(0);
  }

  bind() {
    const { player } = this;
    byId('frame').max = this.frames;
    byId('frame-count').textContent = `of ${this.frames.toLocaleString('en')}`;
    byId('scrub').max = this.frames - 1;
    byId('scrub').addEventListener('input', (event) => this.seek(Number(event.target.value)));
    byId('frame').addEventListener('change', (event) => this.seek(Number(event.target.value) - 1));
    byId('speed').addEventListener('change', (event) => { player.speed = Number(event.target.value); });
    byId('coloring').addEventListener('change', (event) => this.setView({ coloring: event.target.value }));
    const click = {
      first: () => this.seek(0), back: () => this.seek(this.frame - 1), play: () => player.toggle(),
        forward: () => this.seek(this.frame + 1),
      last: () => this.seek(this.frames - 1), fit: () => this.fit(), theme: () => this.switchTheme(),
        'help-open': () => byId('help').showModal(),
      'show-contacts': () => this.setView({ contacts: !this.view.contacts }), 'show-links': () => this.setView({ links: !this.view.links }),
    };
    Object.entries(click).forEach(([id, action]) => byId(id).addEventListener('click', action));
    const step = (by) => (event) => { player.pause(); this.seek(this.frame + (event.shiftKey ? 10 * by : by)); };
    this.keys = {
      ' ': click.play, ArrowLeft: step(-1), ArrowRight: step(1), Home: click.first, End: click.last, '+': () => this.changeSpeed(1),
        '=': () => this.changeSpeed(1),
      '-': () => this.changeSpeed(-1), n: () => this.seekEvent(1), p: () => this.seekEvent(-1), f: click.fit, z: () => this.center(),
      '[': () => this.pickNext(-1), ']': () => this.pickNext(1), c: () => this.nextColoring(), k: click['show-contacts'],
        j: click['show-links'],
      x: () => this.goToDifference(), d: click.theme, '?': click['help-open'], Escape: () => this.pick(null),
      '/': () => { this.openTab('find'); byId('query').focus(); },
    };
    listenToKeys(this);
    listenToTabs(this);
    new ResizeObserver(() => this.redraw()).observe(byId('stages'));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.themeChanged());
  }

  // ---- what is shown ----

  // A frame that was chosen: shown and told at once.
  seek(frame) {
    this.show(Math.max(0, Math.min(this.frames - 1, Number.isFinite(frame) ? Math.round(frame) : 0)));
    this.tell();
  }

  show(frame) {
    this.frame = frame;
    this.redraw();
    byId('scrub').value = frame;
    byId('scrub').setAttribute('aria-valuetext', `update ${frame + 1} of ${this.frames}`);
    if (document.activeElement !== byId('frame')) {
      byId('frame').value = frame + 1;
    }

    byId('clock').textContent = `${this.longest.steps.time[frame].toFixed(3)} s`;

    // While it plays, numbers that change sixty times a second could not be read.
    if (!this.player.isPlaying || performance.now() - this.lastTold > 150) {
      this.tell();
    }
  }

  tell() {
    this.lastTold = performance.now();
    if (this.tab === 'inspect') {
      this.inspector.update();
    } else if (this.tab === 'report') {
      this.report.update();
    } else if (this.tab === 'events') {
      this.eventList.update();
    }
  }

  redraw() {
    this.needsDrawing = true;
  }

  draw() {
    const drawn = this.stages.map((stage) => stage.draw(this.frame, this.view));
    this.isDrawn = drawn.every(Boolean);
    if (this.isDrawn) {
      this.needsDrawing = false;
      this.stages.forEach((stage) => stage.showLegend(this.view));
    }

    this.timeline.draw(this.frame, this.frames, this.view.difference);
  }

  playChanged() {
    const { isPlaying } = this.player;
    byId('play').setAttribute('aria-label', isPlaying ? 'Pause' : 'Play');
    byId('play-icon').setAttribute('d', isPlaying ? 'M3 2h4v12H3zM9 2h4v12H9z' : 'M4 2v12l9-6z');
    this.tell();
  }

  changeSpeed(by) {
    const select = byId('speed');
    select.selectedIndex = Math.max(0, Math.min(select.options.length - 1, select.selectedIndex + by));
    this.player.speed = Number(select.value);
  }

  setView(change) {
    Object.assign(this.view, change);
    byId('coloring').value = this.view.coloring;
    byId('show-contacts').setAttribute('aria-pressed', String(this.view.contacts));
    byId('show-links').setAttribute('aria-pressed', String(this.view.links));
    this.redraw();
  }

  nextColoring() {
    const all = [...byId('coloring').options].map((option) => option.value);
    this.setView({ coloring: all[(all.indexOf(this.view.coloring) + 1) % all.length] });
  }

  openTab(name) {
    this.tab = name;
    for (const tab of document.querySelectorAll('[role="tab"]')) {
      const isOpen = tab.id === `tab-${name}`;
      tab.setAttribute('aria-selected', String(isOpen));
      tab.tabIndex = isOpen ? 0 : -1;
      byId(tab.getAttribute('aria-controls')).hidden = !isOpen;
    }

    this.tell();
  }

  switchTheme() {
    const isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    const now = document.documentElement.dataset.theme ?? (isDark ? 'dark' : 'light');
    document.documentElement.dataset.theme = now === 'dark' ? 'light' : 'dark';
    this.themeChanged();
  }

  themeChanged() {
    readPalette();
    this.tell();
    this.inspector.drawPlots();
    this.redraw();
  }

  fit() {
    const [stage] = this.stages;
    this.camera.fit(this.recordings[0].meta.view, stage.width, stage.height);
    this.redraw();
  }

  // ---- what is picked ----

  pick(thing) {
    this.view.picked = thing;
    this.inspector.reset();
    if (thing && this.tab !== 'inspect') {
      this.openTab('inspect');
    }

    this.redraw();
  }

  pickNext(by) {
    const { picked } = this.view;
    const count = this.recordings[0].meta.bodyCount;
    const from = picked?.type === 'body' ? picked.index : by > 0 ? -1 : 0;
    this.pick({ type: 'body', index: (from + by + count) % count });
  }

  async center() {
    const { picked } = this.view;
    if (!picked) {
      return;
    }

    const recording = this.recordings.find((r) => r.has(picked));
    if (!recording) {
      return;
    }

    const link = picked.type === 'link' ? recording.meta.links[picked.index] : null;
    const body = link ? Math.max(link.a, link.b) : picked.index;
    const row = await recording.rowNow('body', recording.clamp(this.frame), ['x', 'y']);
    if (body >= 0 && body < row.slots) {
      this.camera.x = row.x[row.at + body];
      this.camera.y = row.y[row.at + body];
      this.redraw();
    }
  }

  // ---- events and differences ----

  seekEvent(by) {
    const [recording] = this.recordings;
    const { count, frame } = recording.events;
    const start = by > 0 ? recording.eventStart[recording.clamp(this.frame) + 1] : recording.eventStart[recording.clamp(this.frame)] - 1;
    for (let i = start; i >= 0 && i < count; i += by) {
      if (this.concerns(recording, i)) {
        this.player.pause();
        this.seek(frame[i]);
        return;
      }
    }
  }

  concerns(recording, event) {
    const { picked } = this.view;
    const { kind, a, b } = recording.events;
    if (!picked) {
      return true;
    }

    const { body } = recording.geoms;
    if (kind[event] <= 4) {
      return picked.type === 'body' && (body[a[event]] === picked.index || body[b[event]] === picked.index);
    }

    return picked.type === (kind[event] <= 6 ? 'link' : 'body') && a[event] === picked.index;
  }

  showDifference() {
    const data = byId('difference');
    if (!data) {
      return;
    }

    const found = JSON.parse(data.textContent);
    const bar = byId('difference-bar');
    bar.hidden = false;
    if (found.same) {
      bar.classList.add('same');
      bar.textContent = 'Both runs are the same, bit for bit.';
      return;
    }

    this.view.difference = { frame: found.frame, type: found.subject === 'body' ? 'body' : 'link',
      index: found.subject === 'run' ? -1 : found.index };
    const thing = found.index < 0 ? found.subject : this.recordings[0].nameOf(this.view.difference);
    bar.append(
      make('strong', { text: `First difference in update ${found.frame + 1}` }),
      make('span', { text: `${thing}, ${found.field}` }),
      make('code', { text: `${found.first} \u2260 ${found.second}`, title: `bits ${found.firstBits} and ${found.secondBits}` }),
      make('button', { id: 'go-to-difference', text: 'Go there', title: 'X', onclick: () => this.goToDifference() }),
    );
  }

  goToDifference() {
    const { difference } = this.view;
    if (difference) {
      this.player.pause();
      if (difference.index >= 0) {
        this.pick({ type: difference.type, index: difference.index });
      }

      this.seek(difference.frame);
      this.center();
    }
  }
}

const app = new App();
window.farseer = app;
app.opened = app.open();
