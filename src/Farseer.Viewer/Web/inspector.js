// ---- inspector: what is picked, in numbers and over time ----

const BodyRows = [
  ['x', 'x'], ['y', 'y'], ['angle', 'rotation, rad'], ['vx', 'velocity x'], ['vy', 'velocity y'], ['spin', 'angular velocity'],
  ['mass', 'mass'], ['inertia', 'moment of inertia'],
];
const LinkRows = [['error', 'error'], ['fx', 'force x'], ['fy', 'force y'], ['torque', 'torque']];

class Inspector {
  constructor(panel, app) {
    this.panel = panel;
    this.app = app;
    this.isBusy = false;
  }

  // Something else is picked.
  reset() {
    const { app, panel } = this;
    const thing = app.view.picked;
    this.series = [];
    this.plots = null;
    if (!thing) {
      panel.replaceChildren(
        make('h2', { text: 'Nothing picked' }),
        make('p', { class: 'hint', text: 'Click or tap a body, a joint or a spring, or find one by its name.' }),
        this.overview(),
      );
      return;
    }

    const known = app.recordings.find((recording) => recording.has(thing)) ?? app.recordings[0];
    this.values = make('table', { class: 'values', id: 'values' });
    this.more = make('div');
    this.plotBox = make('div');
    panel.replaceChildren(
      make('h2', { id: 'picked-name', text: known.nameOf(thing) }),
      make('div', { class: 'buttons' },
        make('button', { text: 'Go to', title: 'Centre it (Z)', onclick: () => app.center() }),
        make('button', { text: 'Pick nothing', title: 'Esc', onclick: () => app.pick(null) })),
      this.values,
      this.plotBox,
      this.more,
    );
    this.startSeries(thing);
    this.update();
  }

  overview() {
    const { app } = this;
    const rows = make('table', { class: 'values' });
    for (const [label, read] of [
      ['bodies', (r) => r.meta.bodyCount.toLocaleString('en')], ['geoms', (r) => r.geomCount.toLocaleString('en')],
      ['joints and springs', (r) => r.meta.links.length.toLocaleString('en')], ['updates', (r) => r.frames.toLocaleString('en')],
      ['events', (r) => r.events.count.toLocaleString('en')], ['numbers', precisionText],
    ]) {
      rows.append(make('tr', {}, make('th', { scope: 'row', text: label }), ...app.recordings.map((r) => make('td', { text: read(r) }))));
    }

    return rows;
  }

  startSeries(thing) {
    const { app } = this;
    this.series = app.recordings.filter((recording) => recording.has(thing)).map((recording) => new Series(recording, thing));
    const titles = { speed: 'Speed', energy: 'Kinetic energy', depth: 'Deepest overlap', error: 'Joint error', force: 'Force' };
    this.plots = Object.keys(this.series[0]?.values ?? {}).map((name) => [name, new Plot(titles[name], (frame) => app.seek(frame))]);
    this.plotBox.replaceChildren(...this.plots.map(([, plot]) => plot.element));
    const mine = this.series;
    for (const series of mine) {
      series.run(() => this.drawPlots(), () => this.series === mine);
    }
  }

  drawPlots() {
    const { app } = this;
    for (const [name, plot] of this.plots ?? []) {
      plot.show(this.series.map((series) => series.values[name]), app.frames);
      plot.draw(app.frame);
    }
  }

  // The numbers of the frame that is shown; one question at a time.
  async update() {
    const { app } = this;
    const thing = app.view.picked;
    if (!thing || this.isBusy) {
      this.isBehind = this.isBusy;
      return;
    }

    this.isBusy = true;
    const frame = app.frame;
    const columns = (thing.type === 'body' ? BodyRows : LinkRows).map(([name]) => name);
    const rows = await Promise.all(app.recordings.map((r) => r.rowNow(thing.type, r.clamp(frame), [...columns, 'flags'])));
    const contacts = thing.type === 'body' ? await Promise.all(app.recordings.map((r) => this.contactsOf(r, thing.index, r.clamp(frame))))
      : [];
    this.isBusy = false;
    if (app.view.picked !== thing) {
      this.update();
      return;
    }

    this.fill(thing, rows);
    this.plots?.forEach(([, plot]) => plot.draw(frame));
    this.more.replaceChildren(...this.rest(thing, contacts));
    this.values.dataset.frame = frame;
    if (this.isBehind) {
      this.isBehind = false;
      this.update();
    }
  }

  fill(thing, rows) {
    const { app } = this;
    const lines = [];
    const line = (label, texts, key) => {
      const isUnlike = texts.length > 1 && texts.some((text) => text !== texts[0]);
      const cells = texts.map((text) => make('td', { text, 'data-key': key }));
      lines.push(make('tr', { class: isUnlike ? 'unlike' : null }, make('th', { scope: 'row', text: label }), ...cells));
    };
    if (rows.length > 1) {
      lines.push(make('tr', {}, make('th'), make('td', { text: 'first' }), make('td', { text: 'second' })));
    }

    const there = rows.map((row) => thing.index < row.slots && (row.flags[row.at + thing.index] & There) !== 0);
    line('state', rows.map((row, i) => (there[i] ? this.stateText(thing, row.flags[row.at + thing.index]) : 'not there')), 'state');
    for (const [name, label] of thing.type === 'body' ? BodyRows : LinkRows) {
      line(label, rows.map((row, i) => {
        const spec = app.recordings[i].tracks[thing.type].column(name);
        return there[i] ? columnText(spec, row[name][row.at + thing.index]) : '\u2013';
      }), name);
    }

    this.values.replaceChildren(make('tbody', {}, ...lines));
  }

  stateText(thing, flags) {
    if (thing.type === 'link') {
      return flags & LinkEnabled ? 'holds' : 'off or broken';
    }

    const words = [flags & Static ? 'static' : flags & Kinematic ? 'kinematic' : flags & Awake ? 'awake' : 'asleep'];
    if (!(flags & Enabled)) {
      words.push('disabled');
    }

    if (flags & Lost) {
      words.push('quarantined');
    }

    return words.join(', ');
  }

  async contactsOf(recording, body, frame) {
    if (!recording.meta.hasContacts) {
      return [];
    }

    const names = ['a', 'b', 'there', 'separation', 'push', 'friction'];
    const row = await recording.rowNow('contact', frame, names);
    const own = new Set(recording.geomsOf[body]);
    const found = [];
    for (let i = row.at; i < row.at + row.slots; i++) {
      if (row.there[i] && (own.has(row.a[i]) || own.has(row.b[i]))) {
        const other = recording.geoms.body[own.has(row.a[i]) ? row.b[i] : row.a[i]];
        const text = (name) => columnText(recording.tracks.contact.column(name), row[name][i]);
        found.push({ other, push: text('push'), friction: text('friction'), separation: text('separation') });
      }
    }

    return found;
  }

  rest(thing, contacts) {
    const { app } = this;
    const recording = app.recordings[0];
    const parts = [];
    const bodyLink = (body) => make('button', { class: 'link', text: recording.bodyName(body),
      onclick: () => app.pick({ type: 'body', index: body }) });
    if (thing.type === 'link' && recording.has(thing)) {
      const { a, b } = recording.meta.links[thing.index];
      parts.push(make('h3', { text: 'Joins' }), make('div', {}, a >= 0 ? bodyLink(a) : 'the world', ' and ',
        b >= 0 ? bodyLink(b) : 'the world'));
    }

    if (contacts[0]?.length > 0) {
      const head = make('tr', {}, make('th', { text: 'with' }), make('th', { text: 'impulse' }), make('th', { text: 'friction' }),
        make('th', { text: 'gap' }));
      const lines = contacts[0].slice(0, 60).map(({ other, push, friction, separation }) =>
        make('tr', {}, make('th', { scope: 'row' }, bodyLink(other)), make('td', { text: push }), make('td', { text: friction }),
          make('td', { text: separation })));
      parts.push(make('h3', { text: `Contacts${contacts.length > 1 ? ' (first run)' : ''}` }));
      parts.push(make('table', { class: 'values', id: 'contacts' }, make('thead', {}, head), make('tbody', {}, ...lines)));
    }

    const links = thing.type === 'body' ? recording.linksOf.get(thing.index) ?? [] : [];
    if (links.length > 0) {
      parts.push(make('h3', { text: 'Joints and springs' }));
      parts.push(make('ul', { class: 'list' }, ...links.slice(0, 60).map((index) =>
        make('li', {}, make('button', { class: 'link', text: recording.linkName(index),
          onclick: () => app.pick({ type: 'link', index }) })))));
    }

    return parts;
  }
}

function precisionText(recording) {
  const { digits, contactDigits, hasContacts } = recording.meta;
  if (digits === 0) {
    return hasContacts ? 'all bits' : 'all bits, without contacts';
  }

  return hasContacts ? `${digits} digits, of impulses ${contactDigits}` : `${digits} digits, without contacts`;
}
