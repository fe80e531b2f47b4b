// ---- lists: the events of an update, and what is found by name ----

const MostListed = 150;

class EventList {
  constructor(panel, app) {
    this.panel = panel;
    this.app = app;
  }

  update() {
    const { app, panel } = this;
    const recording = app.recordings[0];
    const frame = recording.clamp(app.frame);
    const start = recording.eventStart[frame];
    const end = recording.eventStart[frame + 1];
    const items = [];
    for (let i = start; i < Math.min(end, start + MostListed); i++) {
      items.push(this.item(recording, i));
    }

    panel.replaceChildren(
      make('h2', { text: `${countText(end - start, 'event', 'events')} in update ${frame + 1}` }),
      make('div', { class: 'buttons' },
        make('button', { text: 'Previous', title: 'P', onclick: () => app.seekEvent(-1) }),
        make('button', { text: 'Next', title: 'N', onclick: () => app.seekEvent(1) })),
      make('ul', { class: 'list', id: 'event-list' }, ...items),
    );
    if (!recording.meta.hasEvents) {
      panel.append(make('p', { class: 'hint', text: 'The run was recorded without events.' }));
    } else if (end - start > MostListed) {
      panel.append(make('p', { class: 'hint', text: `The first ${MostListed} are listed.` }));
    }
  }

  item(recording, i) {
    const { kind, a, b, speed, impulse } = recording.events;
    const pick = (thing, text) => make('button', { class: 'link', text,
      onclick: () => { this.app.pick(thing); this.app.openTab('inspect'); } });
    const geom = (index) => (index < 0 ? 'a geom' : pick({ type: 'body', index: recording.geoms.body[index] }, recording.geomName(index)));
    const li = make('li', {}, make('span', { class: 'kind', style: `--mark:${palette[EventColors[kind[i]]]}`, text: EventNames[kind[i]] }));
    if (kind[i] <= 4) {
      li.append(geom(a[i]), 'and', geom(b[i]));
    } else if (kind[i] <= 6) {
      li.append(a[i] < 0 ? 'a joint' : pick({ type: 'link', index: a[i] }, recording.linkName(a[i])));
    } else {
      li.append(a[i] < 0 ? 'a body' : pick({ type: 'body', index: a[i] }, recording.bodyName(a[i])));
    }

    if (kind[i] === 2) {
      li.append(make('span', { class: 'numbers', text: `at ${shortText(speed[i])}, impulse ${shortText(impulse[i])}` }));
    }

    return li;
  }
}

class Search {
  constructor(panel, app) {
    this.app = app;
    this.query = make('input', { id: 'query', type: 'search', placeholder: 'Name, kind or number',
      'aria-label': 'Find by name, kind or number', autocomplete: 'off' });
    this.count = make('p', { class: 'hint', role: 'status' });
    this.list = make('ul', { class: 'list', id: 'found' });
    this.query.addEventListener('input', () => this.update());
    panel.replaceChildren(make('h2', { text: 'Find' }), this.query, this.count, this.list);
  }

  build() {
    const recording = this.app.recordings[0];
    const { meta } = recording;
    this.things = [];
    for (let index = 0; index < meta.bodyCount; index++) {
      const geoms = recording.geomsOf[index].map((geom) => meta.geoms.names[geom]).filter(Boolean);
      this.add({ type: 'body', index }, recording.bodyName(index) + (geoms.length > 0 ? `: ${[...new Set(geoms)].join(', ')}` : ''));
    }

    meta.links.forEach((_, index) => this.add({ type: 'link', index }, recording.linkName(index)));
    this.update();
  }

  add(thing, text) {
    this.things.push({ thing, text, lower: text.toLowerCase() });
  }

  update() {
    const words = this.query.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = this.things.filter(({ lower }) => words.every((word) =>
      (/^\d+$/.test(word) ? new RegExp(`\\b${word}\\b`).test(lower) : lower.includes(word))));
    this.count.textContent = found.length > MostListed
      ? `${found.length.toLocaleString('en')} found; the first ${MostListed} are listed`
      : `${found.length} found`;
    this.list.replaceChildren(...found.slice(0, MostListed).map(({ thing, text }) => make('li', {}, make('button', {
      class: 'link', text, onclick: () => { this.app.pick(thing); this.app.center(); this.app.openTab('inspect'); },
    }))));
  }
}
