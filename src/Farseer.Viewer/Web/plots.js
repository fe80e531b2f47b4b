// ---- plots: a value over time ----

class Plot {
  constructor(title, onSeek) {
    this.title = title;
    this.lines = [];
    this.value = make('span');
    this.canvas = make('canvas', { class: 'plot', role: 'img' });
    this.element = make('div', {}, make('div', { class: 'plot-head' }, make('span', { text: title }), this.value), this.canvas);
    const seek = (event) => {
      const box = this.canvas.getBoundingClientRect();
      onSeek(Math.round(((event.clientX - box.left) / box.width) * (this.frames - 1)));
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.canvas.addEventListener('pointermove', (event) => event.buttons && seek(event));
  }

  // One array of numbers for each recording.
  show(lines, frames) {
    this.lines = lines;
    this.frames = frames;
    let most = 0;
    let least = 0;
    for (const line of lines) {
      for (const value of line) {
        if (Number.isFinite(value)) {
          most = Math.max(most, value);
          least = Math.min(least, value);
        }
      }
    }

    this.most = most;
    this.least = least;
    this.canvas.setAttribute('aria-label', `${this.title} over time, ${shortText(least)} to ${shortText(most)}`);
  }

  draw(frame) {
    const { canvas, lines, frames, most, least } = this;
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    if (width === 0 || !frames) {
      return;
    }

    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    const span = most - least || 1;
    const x = (f) => (frames > 1 ? (f / (frames - 1)) * (width - 2) + 1 : width / 2);
    const y = (value) => height - 6 - ((value - least) / span) * (height - 24);
    context.fillStyle = palette.line;
    context.fillRect(0, Math.round(y(0)), width, 1);
    lines.forEach((line, i) => this.drawLine(context, line, i, x, y, width));
    context.fillStyle = palette.picked;
    context.fillRect(Math.round(x(frame)) - 1, 0, 2, height);
    context.fillStyle = palette.quiet;
    context.font = '11px system-ui, sans-serif';
    context.textBaseline = 'top';
    context.fillText(shortText(most), 5, 3);
    this.value.textContent = lines.map((line) => shortText(line[Math.min(frame, line.length - 1)])).join('  |  ');
  }

  // Of the frames that share a pixel the least and the most are drawn, so that no peak is lost.
  drawLine(context, line, index, x, y, width) {
    context.beginPath();
    let isDown = false;
    const stride = Math.max(1, line.length / (2 * width));
    for (let from = 0; from < line.length; from += stride) {
      const start = Math.floor(from);
      const end = Math.min(line.length, Math.max(start + 1, Math.floor(from + stride)));
      let low = Infinity;
      let high = -Infinity;
      for (let f = start; f < end; f++) {
        low = Math.min(low, line[f]);
        high = Math.max(high, line[f]);
      }

      if (!Number.isFinite(low)) {
        isDown = false;
        continue;
      }

      if (isDown) {
        context.lineTo(x(start), y(high));
      } else {
        context.moveTo(x(start), y(high));
      }

      context.lineTo(x(start), y(low));
      isDown = true;
    }

    context.lineWidth = 1.5;
    context.lineJoin = 'round';
    context.strokeStyle = index === 0 ? palette['plot-one'] : palette['plot-two'];
    context.setLineDash(index === 0 ? [] : [5, 3]);
    context.stroke();
  }
}
