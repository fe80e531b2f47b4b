// ---- stage: a canvas with one recording on it ----

const PickRadius = 9;

class Stage {
  constructor(recording, camera, label) {
    this.recording = recording;
    this.camera = camera;
    this.painter = new Painter(recording);
    this.canvas = make('canvas', {
      tabindex: 0,
      role: 'img',
      'aria-label': `${label}. Use the Find and Inspect panels to read it; alt with arrows moves the view.`,
    });
    this.legend = make('ul', { class: 'legend' });
    this.element = make('div', { class: 'stage' }, this.canvas, this.legend);
    if (label) {
      this.element.prepend(make('span', { class: 'name', text: label }));
    }

    this.element.prepend(this.canvas);
    this.context = this.canvas.getContext('2d', { alpha: false });
    this.shown = -1;
  }

  get width() {
    return this.canvas.clientWidth;
  }

  get height() {
    return this.canvas.clientHeight;
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.width * ratio));
    const height = Math.max(1, Math.round(this.height * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }

    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  // Draws the frame if it is unpacked; else asks for it, and what was drawn before stays.
  draw(frame, view) {
    const own = this.recording.clamp(frame);
    const rows = this.painter.rows(own, view);
    if (!rows) {
      return false;
    }

    this.resize();
    this.painter.draw(this.context, this.camera, this.width, this.height, own, rows, view);
    this.shown = own;
    for (const [name, columns] of Object.entries(Painter.wanted(view))) {
      this.recording.prefetch(name, own, columns);
    }

    return true;
  }

  // The joint or spring under a point of the canvas, else the body.
  pickAt(px, py, view) {
    const rows = this.painter.rowsNow;
    if (!rows) {
      return null;
    }

    if (view.links) {
      let nearest = PickRadius;
      let found = null;
      this.recording.meta.links.forEach((_, i) => {
        if (i < rows.link.slots && (rows.link.flags[rows.link.at + i] & There)) {
          const distance = distanceToLine(px, py, this.painter.linkPoints(i, rows));
          if (distance < nearest / 2) {
            nearest = 2 * distance;
            found = { type: 'link', index: i };
          }
        }
      });
      if (found) {
        return found;
      }
    }

    return this.bodyAt(px, py);
  }

  bodyAt(px, py) {
    const { painter, recording } = this;
    const { geoms } = recording;
    const rows = painter.rowsNow;
    const [x, y] = this.camera.toWorld(px, py, this.width, this.height);
    let nearest = PickRadius / this.camera.scale;
    let found = null;
    for (let geom = recording.geomCount - 1; geom >= 0; geom--) {
      const body = geoms.body[geom];
      const isHere = geoms.from[geom] <= this.shown && (geoms.to[geom] < 0 || geoms.to[geom] > this.shown);
      if (!isHere || body >= rows.body.slots || !(rows.body.flags[rows.body.at + body] & There)) {
        continue;
      }

      const distance = distanceToGeom(recording, rows.body, geom, x, y);
      if (distance < nearest) {
        nearest = Math.max(distance, 0);
        found = { type: 'body', index: body };
        if (distance <= 0) {
          break;
        }
      }
    }

    return found;
  }

  showLegend(view) {
    const entry = (color, text, dash) => {
      const mark = make('i',
        { style: `color:${color};background:${dash ? 'transparent' : color};border-style:${dash ? 'dashed' : 'solid'}` });
      return make('li', {}, mark, text);
    };
    const items = [];
    if (view.coloring === 'state') {
      items.push(entry(palette.awake, 'awake'), entry(palette.asleep, 'asleep', true), entry(palette.static, 'static'));
      if (this.has((flags) => flags & Kinematic)) {
        items.push(entry(palette.kinematic, 'kinematic'));
      }

      if (this.recording.geoms.sensor.includes(1)) {
        items.push(entry(palette.sensor, 'sensor', true));
      }
    } else if (view.coloring === 'island') {
      items.push(entry(IslandHues[0], 'a colour an island'), entry(IslandHues[0], 'asleep', true));
    } else {
      items.push(entry(SpeedRamp[0], 'slow'), entry(SpeedRamp[9], `fast (${shortText(this.painter.topSpeed)})`));
    }

    if (view.contacts && this.recording.meta.hasContacts) {
      items.push(entry(palette.contact, 'contact, as long as the root of its impulse'));
    }

    const signature = items.map((item) => item.textContent).join() + palette.awake;
    if (signature !== this.legendSignature) {
      this.legendSignature = signature;
      this.legend.replaceChildren(...items);
    }
  }

  has(test) {
    const rows = this.painter.rowsNow;
    return rows && rows.body.flags.subarray(rows.body.at, rows.body.at + rows.body.slots).some(test);
  }
}

function distanceToLine(px, py, points) {
  let least = Infinity;
  for (let i = 0; i + 1 < points.length; i++) {
    const [ax, ay] = points[i];
    const [bx, by] = points[i + 1];
    least = Math.min(least, distanceToSegment(px, py, ax, ay, bx, by));
  }

  return least;
}

function distanceToSegment(x, y, ax, ay, bx, by) {
  const dx = bx - ax;
  const dy = by - ay;
  const square = dx * dx + dy * dy;
  const share = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}

// 0 or less inside.
function distanceToGeom(recording, row, geom, x, y) {
  const { geoms } = recording;
  const at = row.at + geoms.body[geom];
  const shape = recording.shapes[geoms.shape[geom]];
  const bodyCos = Math.cos(row.angle[at]);
  const bodySin = Math.sin(row.angle[at]);
  const inBodyX = bodyCos * (x - row.x[at]) + bodySin * (y - row.y[at]) - geoms.x[geom];
  const inBodyY = bodyCos * (y - row.y[at]) - bodySin * (x - row.x[at]) - geoms.y[geom];
  const cos = recording.cosines[geom];
  const sin = recording.sines[geom];
  const lx = cos * inBodyX + sin * inBodyY;
  const ly = cos * inBodyY - sin * inBodyX;
  if (shape.kind === 'circle') {
    return Math.hypot(lx, ly) - shape.radius;
  }

  const { points } = shape;
  const count = points.length / 2;
  const isOpen = shape.kind === 'line';
  let least = Infinity;
  let isInside = false;
  for (let i = 0, j = count - 1; i < count; j = i++) {
    if (isOpen && i === 0) {
      continue;
    }

    const [ax, ay, bx, by] = [points[2 * j], points[2 * j + 1], points[2 * i], points[2 * i + 1]];
    least = Math.min(least, distanceToSegment(lx, ly, ax, ay, bx, by));
    if ((ay > ly) !== (by > ly) && lx < ax + ((ly - ay) / (by - ay)) * (bx - ax)) {
      isInside = !isInside;
    }
  }

  return (isInside && !isOpen ? -least : least) - shape.radius;
}
