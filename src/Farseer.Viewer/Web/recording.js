// ---- recording: what happened, unpacked as it is needed ----

const There = 1;
const Awake = 2;
const Enabled = 4;
const Static = 8;
const Kinematic = 16;
const Lost = 32;

// Of joints and springs.
const LinkEnabled = 2;

const MostUnpackedBytes = 400e6;

class Track {
  constructor(meta, blocks) {
    this.columns = meta?.columns ?? [];
    this.chunks = (meta?.chunks ?? []).map(([first, frames, slots, block]) =>
      ({ first, frames, slots, block, used: 0, columns: new Map(), waiting: new Map() }));
    this.blocks = blocks;
    this.index = new Map(this.columns.map((column, i) => [column.name, i]));
  }

  column(name) {
    return this.columns[this.index.get(name)];
  }

  chunkAt(frame) {
    let low = 0;
    let high = this.chunks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.chunks[middle].first <= frame) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }

    return high < 0 ? null : this.chunks[low];
  }

  // The numbers of a column, or undefined while they are packed.
  ready(chunk, name) {
    return chunk.columns.get(name);
  }

  load(chunk, name, onLoaded) {
    const at = chunk.waiting.get(name);
    if (at) {
      return at;
    }

    if (chunk.columns.has(name)) {
      return Promise.resolve(chunk.columns.get(name));
    }

    const index = this.index.get(name);
    const waiting = this.blocks.column(chunk.block + index, this.columns[index], chunk.frames, chunk.slots).then((values) => {
      chunk.columns.set(name, values);
      chunk.waiting.delete(name);
      onLoaded?.(values.byteLength);
      return values;
    });
    chunk.waiting.set(name, waiting);
    return waiting;
  }
}

class Recording {
  constructor(meta, text, number) {
    this.meta = meta;
    this.number = number;
    this.frames = meta.frames;
    this.blocks = new Blocks(text);
    this.tracks = {};
    for (const name of ['body', 'link', 'fluid', 'contact', 'event', 'step']) {
      this.tracks[name] = new Track(meta.tracks[name], this.blocks);
    }

    this.unpacked = 0;
    this.clock = 0;
    this.shapes = meta.shapes.map(readyShape);
    const geoms = meta.geoms;
    this.geomCount = geoms.body.length;
    this.geoms = geoms;
    this.cosines = Float64Array.from(geoms.turn, Math.cos);
    this.sines = Float64Array.from(geoms.turn, Math.sin);
    this.geomsOf = Array.from({ length: meta.bodyCount }, () => []);
    geoms.body.forEach((body, geom) => this.geomsOf[body].push(geom));
    this.linksOf = new Map();
    meta.links.forEach((link, i) => {
      for (const body of [link.a, link.b]) {
        if (body >= 0) {
          this.linksOf.set(body, [...(this.linksOf.get(body) ?? []), i]);
        }
      }
    });
    this.steps = {};
  }

  // The step track and the events are small and wanted everywhere: they are unpacked at the start.
  async open() {
    const step = this.tracks.step;
    for (const spec of step.columns) {
      const all = new Float64Array(this.frames);
      for (const chunk of step.chunks) {
        all.set(await step.load(chunk, spec.name), chunk.first);
      }

      this.steps[spec.name] = all;
    }

    await this.openEvents();
  }

  async openEvents() {
    const track = this.tracks.event;
    const count = track.chunks.reduce((sum, chunk) => sum + chunk.slots, 0);
    this.events = { count };
    for (const name of ['frame', 'kind', 'a', 'b', 'speed', 'impulse']) {
      const all = name === 'speed' || name === 'impulse' ? new Float32Array(count) : new Int32Array(count);
      let at = 0;
      for (const chunk of track.chunks) {
        all.set(await track.load(chunk, name), at);
        at += chunk.slots;
      }

      this.events[name] = all;
    }

    // Where the events of a frame begin.
    this.eventStart = new Int32Array(this.frames + 1);
    for (let i = 0; i < count; i++) {
      this.eventStart[this.events.frame[i] + 1]++;
    }

    for (let f = 0; f < this.frames; f++) {
      this.eventStart[f + 1] += this.eventStart[f];
    }
  }

  clamp(frame) {
    return Math.max(0, Math.min(this.frames - 1, frame));
  }

  // The numbers of a track in a frame by the names of columns; null while some are packed, which are asked for then.
  row(name, frame, columns) {
    const track = this.tracks[name];
    const chunk = track.chunkAt(frame);
    if (!chunk) {
      return { slots: 0, at: 0 };
    }

    chunk.used = ++this.clock;
    const row = { slots: chunk.slots, at: (frame - chunk.first) * chunk.slots, chunk };
    let isReady = true;
    for (const column of columns) {
      const values = track.ready(chunk, column);
      if (values) {
        row[column] = values;
      } else {
        isReady = false;
        this.fetchColumn(track, chunk, column);
      }
    }

    return isReady ? row : null;
  }

  async rowNow(name, frame, columns) {
    const track = this.tracks[name];
    const chunk = track.chunkAt(frame);
    if (chunk) {
      await Promise.all(columns.map((column) => this.fetchColumn(track, chunk, column)));
    }

    const row = { slots: chunk?.slots ?? 0, at: chunk ? (frame - chunk.first) * chunk.slots : 0, chunk };
    for (const column of columns) {
      row[column] = chunk?.columns.get(column);
    }

    return row;
  }

  fetchColumn(track, chunk, column) {
    return track.load(chunk, column, (bytes) => {
      this.unpacked += bytes;
      chunk.used = ++this.clock;
      this.makeRoom(chunk);
    });
  }

  // Asks for what will be shown after this chunk.
  prefetch(name, frame, columns) {
    const track = this.tracks[name];
    const chunk = track.chunkAt(frame);
    const next = chunk && track.chunks[track.chunks.indexOf(chunk) + 1];
    if (next) {
      columns.forEach((column) => this.fetchColumn(track, next, column));
    }
  }

  makeRoom(keep) {
    const chunks = ['body', 'contact', 'link', 'fluid'].flatMap((name) => this.tracks[name].chunks).filter((chunk) =>
      chunk !== keep && chunk.columns.size > 0);
    chunks.sort((a, b) => a.used - b.used);
    while (this.unpacked > MostUnpackedBytes && chunks.length > 2) {
      const chunk = chunks.shift();
      for (const values of chunk.columns.values()) {
        this.unpacked -= values.byteLength;
      }

      chunk.columns.clear();
    }
  }

  // ---- names ----

  bodyName(body) {
    const name = this.meta.bodyNames[body];
    return name ? `${name} (body ${body})` : `body ${body}`;
  }

  geomName(geom) {
    if (geom < 0) {
      return 'a geom';
    }

    const name = this.meta.geoms.names[geom];
    return name ? `${name} (${this.bodyName(this.geoms.body[geom])})` : this.bodyName(this.geoms.body[geom]);
  }

  linkName(link) {
    const { kind, name, spring } = this.meta.links[link];
    const word = spring ? 'spring' : 'joint';
    return name ? `${name} (${word} ${link}, ${kind})` : `${kind} (${word} ${link})`;
  }

  nameOf(thing) {
    return thing.type === 'body' ? this.bodyName(thing.index) : this.linkName(thing.index);
  }

  has(thing) {
    return thing.index >= 0 && thing.index < (thing.type === 'body' ? this.meta.bodyCount : this.meta.links.length);
  }
}

function readyShape(shape) {
  const points = Float64Array.from(shape.points);
  let reach = 0;
  for (let i = 0; i < points.length; i += 2) {
    reach = Math.max(reach, Math.hypot(points[i], points[i + 1]));
  }

  return { kind: shape.kind, radius: shape.radius, points, reach: reach + shape.radius };
}
