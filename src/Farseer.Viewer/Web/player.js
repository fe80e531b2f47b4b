// ---- player: the clock ----

class Player {
  constructor(app) {
    this.app = app;
    this.isPlaying = false;
    this.speed = 1;
    this.carry = 0;
    this.last = 0;
    // How long each drawing took, ms, and when it was: for who wants to know.
    this.drawTimes = [];
    this.pictureTimes = [];
    requestAnimationFrame((now) => this.tick(now));
  }

  toggle() {
    const { app } = this;
    this.isPlaying = !this.isPlaying;
    if (this.isPlaying && app.frame >= app.frames - 1) {
      app.seek(0);
    }

    this.carry = 0;
    this.last = performance.now();
    app.playChanged();
  }

  pause() {
    if (this.isPlaying) {
      this.toggle();
    }
  }

  tick(now) {
    const { app } = this;
    // The scene's time goes on only while pictures do: one that is still packed is waited for.
    if (this.isPlaying && app.isDrawn) {
      this.advance(Math.min(0.25, (now - this.last) / 1000) * this.speed);
    }

    this.last = now;
    if (!app.isDrawn || app.needsDrawing) {
      const start = performance.now();
      app.draw();
      if (app.isDrawn) {
        this.note(this.drawTimes, performance.now() - start);
        this.note(this.pictureTimes, now);
      }
    }

    requestAnimationFrame((next) => this.tick(next));
  }

  note(times, value) {
    times.push(value);
    if (times.length > 1000) {
      times.shift();
    }
  }

  advance(seconds) {
    const { app } = this;
    const { dt } = app.longest.steps;
    this.carry += seconds;
    let frame = app.frame;
    while (frame < app.frames - 1) {
      const step = dt[frame + 1] > 0 ? dt[frame + 1] : 1 / 60;
      if (this.carry < step * 0.999) {
        break;
      }

      this.carry -= step;
      frame++;
    }

    if (frame !== app.frame) {
      app.show(frame);
    }

    if (frame >= app.frames - 1) {
      this.pause();
    }
  }
}
