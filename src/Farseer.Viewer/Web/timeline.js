// ---- timeline: which events there are when, a row a kind ----

const EventRows = [
  { label: 'begin', color: 'event-begin', kinds: [0] },
  { label: 'end', color: 'event-end', kinds: [1] },
  { label: 'hit', color: 'event-hit', kinds: [2] },
  { label: 'sensor', color: 'event-sensor', kinds: [3, 4] },
  { label: 'broke', color: 'event-broke', kinds: [5, 6] },
  { label: 'sleep, wake', color: 'event-sleep', kinds: [7, 8] },
];

const EventNames = ['contact', 'parted', 'hit', 'entered', 'left', 'joint broke', 'spring broke', 'asleep', 'awake'];
const EventColors = ['event-begin', 'event-end', 'event-hit', 'event-sensor', 'event-sensor', 'event-broke', 'event-broke', 'event-sleep',
  'event-sleep'];

class Timeline {
  constructor(canvas, recording, onSeek) {
    this.canvas = canvas;
    this.recording = recording;
    this.counts = EventRows.map(() => new Int32Array(recording.frames));
    const rowOf = [];
    EventRows.forEach((row, i) => row.kinds.forEach((kind) => { rowOf[kind] = i; }));
    for (let i = 0; i < recording.events.count; i++) {
      this.counts[rowOf[recording.events.kind[i]]][recording.events.frame[i]]++;
    }

    this.most = this.counts.map((row) => row.reduce((a, b) => Math.max(a, b), 1));
    const seek = (event) => {
      const box = canvas.getBoundingClientRect();
      onSeek(Math.round(((event.clientX - box.left - this.left) / (box.width - this.left)) * (this.frames - 1)));
    };
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    canvas.addEventListener('pointermove', (event) => event.buttons && seek(event));
    this.frames = recording.frames;
  }

  get left() {
    return this.canvas.clientWidth > 600 ? 80 : 0;
  }

  draw(frame, frames, difference) {
    const { canvas } = this;
    this.frames = frames;
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    const ratio = window.devicePixelRatio || 1;
    const signature = [width, height, ratio, frames, palette.ground].join();
    if (signature !== this.signature) {
      this.signature = signature;
      canvas.parentElement.style.setProperty('--labels', `${this.left}px`);
      this.paintEvents(width, height, ratio);
    }

    const context = canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.image, 0, 0);
    context.scale(ratio, ratio);
    const x = (f) => this.left + (f / Math.max(1, frames - 1)) * (width - this.left - 2) + 1;
    if (difference) {
      const at = x(difference.frame);
      context.fillStyle = palette.difference;
      context.fillRect(at - 1, 0, 2, height);
      context.beginPath();
      context.moveTo(at - 6, 0);
      context.lineTo(at + 6, 0);
      context.lineTo(at, 9);
      context.fill();
    }

    context.fillStyle = palette.picked;
    context.fillRect(x(frame) - 1, 0, 2.5, height);
  }

  paintEvents(width, height, ratio) {
    const { canvas, recording, frames } = this;
    canvas.width = Math.max(1, Math.round(width * ratio));
    canvas.height = Math.max(1, Math.round(height * ratio));
    this.image = document.createElement('canvas');
    this.image.width = canvas.width;
    this.image.height = canvas.height;
    const context = this.image.getContext('2d');
    context.scale(ratio, ratio);
    context.fillStyle = palette.ground;
    context.fillRect(0, 0, width, height);
    const rowHeight = height / EventRows.length;
    const step = (width - this.left - 2) / Math.max(1, frames - 1);
    EventRows.forEach((row, i) => {
      const top = i * rowHeight;
      context.fillStyle = palette.line;
      context.fillRect(this.left, Math.round(top + rowHeight) - 1, width, 1);
      if (this.left > 0) {
        context.fillStyle = palette.quiet;
        context.font = '11px system-ui, sans-serif';
        context.textBaseline = 'middle';
        context.fillText(row.label, 4, top + rowHeight / 2);
      }

      context.fillStyle = palette[row.color];
      for (let f = 0; f < recording.frames; f++) {
        const count = this.counts[i][f];
        if (count > 0) {
          const share = 0.35 + 0.65 * (Math.log(1 + count) / Math.log(1 + this.most[i]));
          const bar = share * (rowHeight - 2);
          context.fillRect(this.left + f * step, top + rowHeight - 1 - bar, Math.max(1.5, Math.min(6, step)), bar);
        }
      }
    });
  }
}
