// ---- painter: draws one frame of a recording ----

const Colors = [
  'scene', 'scene-grid', 'awake', 'awake-fill', 'asleep', 'asleep-fill', 'static', 'static-fill', 'kinematic', 'kinematic-fill', 'sensor',
  'lost', 'lost-fill', 'joint', 'spring', 'contact', 'fluid', 'picked', 'difference', 'text', 'quiet', 'line', 'ground',
  'event-begin', 'event-end', 'event-hit', 'event-sensor', 'event-broke', 'event-sleep', 'plot-one', 'plot-two', 'focus',
];

// Islands: eight hues that keep apart, in two strengths. Speed: dark to bright, which also reads in grey.
const IslandHues = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#b8a900', '#7a68c8'];
const SpeedRamp = ['#440154', '#482878', '#3e4a89', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];

// Outlines in a path: one each is slow for the calls, all in one for the browser, which looks for what crosses what.
const BatchSize = 32;

const palette = {};

function readPalette() {
  const probe = make('span', { hidden: true });
  document.body.append(probe);
  for (const name of Colors) {
    probe.style.color = `var(--${name})`;
    palette[name] = getComputedStyle(probe).color;
  }

  probe.remove();
}

class Painter {
  constructor(recording) {
    this.recording = recording;
    this.islands = new Islands(recording);
    this.buckets = new Map();
    this.topSpeed = 1;
    this.strongest = 0;
  }

  // The columns that are wanted of each track; what is not shown is not unpacked.
  static wanted(view) {
    const byIsland = view.coloring === 'island';
    const body = ['x', 'y', 'angle', 'flags'];
    return {
      body: view.coloring === 'speed' ? [...body, 'vx', 'vy'] : body,
      link: ['flags', 'tx', 'ty'],
      fluid: ['x', 'y'],
      contact: view.contacts ? ['x', 'y', 'nx', 'ny', 'push', 'there', 'a', 'b'] : byIsland ? ['there', 'a', 'b'] : [],
    };
  }

  // All rows of a frame, or null while some are packed.
  rows(frame, view) {
    const rows = {};
    let isReady = true;
    for (const [name, columns] of Object.entries(Painter.wanted(view))) {
      rows[name] = this.recording.row(name, frame, columns);
      isReady &&= rows[name] !== null;
    }

    return isReady ? rows : null;
  }

  draw(context, camera, width, height, frame, rows, view) {
    this.context = context;
    this.camera = camera;
    this.width = width;
    this.height = height;
    this.frame = frame;
    this.rowsNow = rows;
    context.fillStyle = palette.scene;
    context.fillRect(0, 0, width, height);
    this.drawGrid();
    this.drawFluids(rows.fluid);
    this.drawGeoms(rows, view);
    if (view.links) {
      this.drawLinks(rows);
    }

    if (view.contacts) {
      drawContacts(this, rows.contact);
    }

    if (view.difference && frame >= view.difference.frame && this.recording.has(view.difference)) {
      this.mark(view.difference, palette.difference, 6);
    }

    if (view.picked && this.recording.has(view.picked)) {
      this.mark(view.picked, palette.picked, 3);
    }
  }

  // Lines at powers of ten, so that lengths can be judged.
  drawGrid() {
    const { context, camera, width, height } = this;
    const step = 10 ** Math.ceil(Math.log10(70 / camera.scale));
    context.beginPath();
    const [left, top] = camera.toWorld(0, 0, width, height);
    const [right, bottom] = camera.toWorld(width, height, width, height);
    for (let x = Math.ceil(left / step) * step; x < right; x += step) {
      const [px] = camera.toScreen(x, 0, width, height);
      context.moveTo(px, 0);
      context.lineTo(px, height);
    }

    for (let y = Math.ceil(Math.min(top, bottom) / step) * step; y < Math.max(top, bottom); y += step) {
      const [, py] = camera.toScreen(0, y, width, height);
      context.moveTo(0, py);
      context.lineTo(width, py);
    }

    context.lineWidth = 1;
    context.strokeStyle = palette['scene-grid'];
    context.stroke();
  }

  drawFluids(row) {
    let at = row.at;
    for (const count of this.recording.meta.fluids) {
      this.context.beginPath();
      for (let i = 0; i < count; i++) {
        const [px, py] = this.camera.toScreen(row.x[at + i], row.y[at + i], this.width, this.height);
        this.context.lineTo(px, py);
      }

      this.context.closePath();
      this.context.globalAlpha = 0.25;
      this.context.fillStyle = palette.fluid;
      this.context.fill();
      this.context.globalAlpha = 1;
      at += count;
    }
  }

  // Geoms of one look are drawn together: that is what makes thousands fast.
  drawGeoms(rows, view) {
    const { geoms, geomCount } = this.recording;
    const looks = this.looks(rows, view);
    this.buckets.forEach((bucket) => { bucket.length = 0; });
    for (let geom = 0; geom < geomCount; geom++) {
      const body = geoms.body[geom];
      if (geoms.from[geom] > this.frame || (geoms.to[geom] >= 0 && geoms.to[geom] <= this.frame) || body >= rows.body.slots) {
        continue;
      }

      if (!(rows.body.flags[rows.body.at + body] & There)) {
        continue;
      }

      const look = geoms.sensor[geom] ? 'sensor' : looks(body);
      let bucket = this.buckets.get(look);
      if (!bucket) {
        this.buckets.set(look, bucket = []);
      }

      bucket.push(geom);
    }

    for (const [look, bucket] of this.buckets) {
      if (bucket.length > 0) {
        this.drawBucket(bucket, Painter.style(look));
      }
    }
  }

  looks(rows, view) {
    const { body } = rows;
    const state = (i) => {
      const flags = body.flags[body.at + i];
      return flags & Lost ? 'lost' : flags & Static ? 'static' : flags & Kinematic ? 'kinematic' : flags & Awake && flags & Enabled
        ? 'awake' : 'asleep';
    };
    if (view.coloring === 'island') {
      const roots = this.islands.find(this.frame, body, rows.contact, rows.link);
      return (i) => (roots[i] < 0 ? state(i) : `island${(roots[i] * 5) % IslandHues.length}${state(i) === 'asleep' ? 's' : ''}`);
    }

    if (view.coloring === 'speed') {
      let fastest = 0;
      const speed = (i) => Math.hypot(body.vx[body.at + i], body.vy[body.at + i]);
      for (let i = 0; i < body.slots; i++) {
        fastest = Math.max(fastest, speed(i));
      }

      this.topSpeed = fastest;
      return (i) => {
        const kind = state(i);
        const share = fastest > 0 ? Math.sqrt(speed(i) / fastest) : 0;
        return kind === 'awake' ? `speed${Math.min(SpeedRamp.length - 1, Math.floor(share * SpeedRamp.length))}` : kind;
      };
    }

    return state;
  }

  static style(look) {
    if (look.startsWith('island')) {
      const hue = IslandHues[Number(look[6])];
      return look.endsWith('s') ? { line: hue, fill: hue, alpha: 0.14, dash: true } : { line: hue, fill: hue, alpha: 0.5 };
    }

    if (look.startsWith('speed')) {
      const color = SpeedRamp[Number(look[5])];
      return { line: palette.quiet, fill: color, alpha: 0.9 };
    }

    if (look === 'sensor') {
      return { line: palette.sensor, fill: null, alpha: 1, dash: true };
    }

    return { line: palette[look], fill: palette[`${look}-fill`], alpha: 1, dash: look === 'asleep' };
  }

  drawBucket(bucket, style) {
    const { context } = this;
    context.fillStyle = style.fill ?? 'transparent';
    context.strokeStyle = style.line;
    context.lineWidth = bucket.length > 3000 ? 0.75 : 1.25;
    context.setLineDash(style.dash && bucket.length < 3000 ? [4, 3] : []);
    for (let from = 0; from < bucket.length; from += BatchSize) {
      context.beginPath();
      let isLarge = false;
      for (let i = from; i < Math.min(bucket.length, from + BatchSize); i++) {
        isLarge = this.traceGeom(bucket[i]) || isLarge;
      }

      if (style.fill) {
        context.globalAlpha = style.alpha;
        context.fill();
        context.globalAlpha = 1;
      }

      if (isLarge || !style.fill) {
        context.stroke();
      }
    }

    context.setLineDash([]);
  }

  // Adds the outline of a geom to the path; true if it is large enough for a line around it.
  traceGeom(geom) {
    const { recording, camera, context, width, height } = this;
    const row = this.rowsNow.body;
    const { geoms } = recording;
    const at = row.at + geoms.body[geom];
    const bodyCos = Math.cos(row.angle[at]);
    const bodySin = Math.sin(row.angle[at]);
    const ox = geoms.x[geom];
    const oy = geoms.y[geom];
    const scale = camera.scale;
    const up = camera.up;
    const px = width / 2 + (row.x[at] - camera.x + bodyCos * ox - bodySin * oy) * scale;
    const py = height / 2 + (row.y[at] - camera.y + bodySin * ox + bodyCos * oy) * scale * up;
    const shape = recording.shapes[geoms.shape[geom]];
    const reach = shape.reach * scale;
    if (px + reach < 0 || px - reach > width || py + reach < 0 || py - reach > height) {
      return false;
    }

    if (reach < 1.2) {
      context.rect(px - 0.7, py - 0.7, 1.4, 1.4);
      return false;
    }

    const cos = (bodyCos * recording.cosines[geom] - bodySin * recording.sines[geom]) * scale;
    const sin = (bodySin * recording.cosines[geom] + bodyCos * recording.sines[geom]) * scale;
    if (shape.kind === 'circle') {
      const radius = shape.radius * scale;
      context.moveTo(px + radius, py);
      context.arc(px, py, radius, 0, 2 * Math.PI);
      if (radius > 3) {
        context.moveTo(px, py);
        context.lineTo(px + cos * shape.radius, py + sin * up * shape.radius);
      }

      return true;
    }

    if (shape.kind === 'round') {
      this.traceRound(shape, px, py, cos, sin);
      return true;
    }

    const { points } = shape;
    for (let i = 0; i < points.length; i += 2) {
      const x = px + cos * points[i] - sin * points[i + 1];
      const y = py + (sin * points[i] + cos * points[i + 1]) * up;
      if (i === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    }

    if (shape.kind === 'outline') {
      context.closePath();
    }

    return reach > 2.2;
  }

  // All points within a radius of a convex polygon or a segment: its edges moved outwards, joined by arcs.
  traceRound(shape, px, py, cos, sin) {
    const { points, radius } = shape;
    const { context, camera } = this;
    const count = points.length / 2;
    const r = radius * camera.scale;
    let area = 0;
    for (let i = 0; i < count; i++) {
      const j = (i + 1) % count;
      area += points[2 * i] * points[2 * j + 1] - points[2 * j] * points[2 * i + 1];
    }

    const turn = (area < 0 ? -1 : 1) * camera.up;
    const at = (i) => [
      px + cos * points[2 * i] - sin * points[2 * i + 1],
      py + (sin * points[2 * i] + cos * points[2 * i + 1]) * camera.up,
    ];
    for (let i = 0; i < count; i++) {
      const [x0, y0] = at((i + count - 1) % count);
      const [x, y] = at(i);
      const [x1, y1] = at((i + 1) % count);
      const before = Math.atan2(y - y0, x - x0) - (turn * Math.PI) / 2;
      const after = Math.atan2(y1 - y, x1 - x) - (turn * Math.PI) / 2;
      if (i === 0) {
        context.moveTo(x + r * Math.cos(before), y + r * Math.sin(before));
      }

      context.arc(x, y, r, before, after, turn < 0);
    }

    context.closePath();
  }

  // Where a point of a body is on the screen.
  place(row, body, x, y) {
    const at = row.at + body;
    const cos = Math.cos(row.angle[at]);
    const sin = Math.sin(row.angle[at]);
    return this.camera.toScreen(row.x[at] + cos * x - sin * y, row.y[at] + sin * x + cos * y, this.width, this.height);
  }

  // The points of a joint or spring on the screen, from one end to the other.
  linkPoints(index, rows) {
    const link = this.recording.meta.links[index];
    const there = (body) => body >= 0 && body < rows.body.slots && (rows.body.flags[rows.body.at + body] & There);
    const points = [];
    if (there(link.a)) {
      points.push(this.place(rows.body, link.a, 0, 0), this.place(rows.body, link.a, link.at[0], link.at[1]));
    }

    if (link.over) {
      points.push(this.camera.toScreen(link.over[0], link.over[1], this.width, this.height));
      points.push(this.camera.toScreen(link.over[2], link.over[3], this.width, this.height));
    }

    if (link.world) {
      points.push(this.camera.toScreen(rows.link.tx[rows.link.at + index], rows.link.ty[rows.link.at + index], this.width, this.height));
    } else if (there(link.b)) {
      points.push(this.place(rows.body, link.b, link.at[2], link.at[3]), this.place(rows.body, link.b, 0, 0));
    }

    return points;
  }

  drawLinks(rows) {
    const { context } = this;
    const { links } = this.recording.meta;
    context.lineWidth = links.length > 2000 ? 1 : 1.75;
    for (const spring of [false, true]) {
      context.strokeStyle = spring ? palette.spring : palette.joint;
      context.setLineDash(spring ? [2, 3] : []);
      context.beginPath();
      let traced = 0;
      for (let i = 0; i < Math.min(links.length, rows.link.slots); i++) {
        const flags = rows.link.flags[rows.link.at + i];
        if ((flags & There) && (flags & LinkEnabled) && links[i].spring === spring) {
          this.tracePoints(this.linkPoints(i, rows));
          if (++traced % BatchSize === 0) {
            context.stroke();
            context.beginPath();
          }
        }
      }

      context.stroke();
    }

    context.setLineDash([]);
  }

  tracePoints(points) {
    points.forEach(([x, y], i) => (i === 0 ? this.context.moveTo(x, y) : this.context.lineTo(x, y)));
    const radius = Math.min(2.5, this.camera.scale * this.smallestReach() * 0.25);
    if (radius > 0.7 && this.recording.meta.links.length <= 2000) {
      for (const [x, y] of points) {
        this.context.moveTo(x + radius, y);
        this.context.arc(x, y, radius, 0, 2 * Math.PI);
      }
    }
  }

  smallestReach() {
    this.smallest ??= this.recording.shapes.reduce((least, shape) => Math.min(least, shape.reach), Infinity);
    return this.smallest;
  }

  // A line around what is picked or differs.
  mark(thing, color, width) {
    const { context, recording, rowsNow } = this;
    context.beginPath();
    if (thing.type === 'body') {
      if (thing.index >= rowsNow.body.slots || !(rowsNow.body.flags[rowsNow.body.at + thing.index] & There)) {
        return;
      }

      for (const geom of recording.geomsOf[thing.index]) {
        if (recording.geoms.from[geom] <= this.frame && (recording.geoms.to[geom] < 0 || recording.geoms.to[geom] > this.frame)) {
          this.traceGeom(geom);
        }
      }

      const [x, y] = this.place(rowsNow.body, thing.index, 0, 0);
      const arm = Math.min(5, this.camera.scale * this.smallestReach() * 0.4);
      context.moveTo(x - arm, y);
      context.lineTo(x + arm, y);
      context.moveTo(x, y - arm);
      context.lineTo(x, y + arm);
    } else if (thing.index < rowsNow.link.slots) {
      this.tracePoints(this.linkPoints(thing.index, rowsNow));
    }

    context.lineWidth = Math.max(1.5, Math.min(width, this.camera.scale * this.smallestReach()));
    context.strokeStyle = color;
    context.stroke();
  }
}
