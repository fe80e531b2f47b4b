// ---- series: what is picked, over all frames ----

// Unpacks chunk after chunk and tells after each how far it is; ends when told that it is no more wanted.
class Series {
  constructor(recording, thing) {
    this.recording = recording;
    this.thing = thing;
    this.values = {};
    this.done = 0;
    const names = thing.type === 'body' ? ['speed', 'energy', 'depth'] : ['error', 'force'];
    names.forEach((name) => { this.values[name] = new Float64Array(recording.frames).fill(NaN); });
  }

  async run(onProgress, isWanted) {
    const track = this.recording.tracks[this.thing.type];
    for (const chunk of track.chunks) {
      if (!isWanted()) {
        return;
      }

      if (this.thing.type === 'body') {
        await this.addBody(chunk);
      } else {
        await this.addLink(chunk);
      }

      this.done = chunk.first + chunk.frames;
      onProgress();
      await new Promise((resume) => { setTimeout(resume); });
    }
  }

  async addBody(chunk) {
    const { recording, thing, values } = this;
    const names = ['vx', 'vy', 'spin', 'mass', 'inertia', 'flags'];
    const [vx, vy, spin, mass, inertia, flags] = await Promise.all(names.map((name) =>
      recording.fetchColumn(recording.tracks.body, chunk, name)));
    if (thing.index >= chunk.slots) {
      return;
    }

    for (let f = 0; f < chunk.frames; f++) {
      const i = f * chunk.slots + thing.index;
      if (flags[i] & There) {
        const square = vx[i] * vx[i] + vy[i] * vy[i];
        values.speed[chunk.first + f] = Math.sqrt(square);
        values.energy[chunk.first + f] = flags[i] & Static ? 0 : (mass[i] * square + inertia[i] * spin[i] * spin[i]) / 2;
        values.depth[chunk.first + f] = 0;
      }
    }

    await this.addDepths(chunk);
  }

  async addDepths({ first, frames }) {
    const { recording, thing, values } = this;
    const own = new Set(recording.geomsOf[thing.index]);
    for (const chunk of recording.tracks.contact.chunks) {
      if (chunk.first + chunk.frames <= first || chunk.first >= first + frames) {
        continue;
      }

      const names = ['a', 'b', 'there', 'separation'];
      const [a, b, there, separation] = await Promise.all(names.map((name) =>
        recording.fetchColumn(recording.tracks.contact, chunk, name)));
      for (let i = 0; i < chunk.frames * chunk.slots; i++) {
        if (there[i] && (own.has(a[i]) || own.has(b[i]))) {
          const frame = chunk.first + Math.floor(i / chunk.slots);
          values.depth[frame] = Math.max(values.depth[frame], -separation[i]);
        }
      }
    }
  }

  async addLink(chunk) {
    const { recording, thing, values } = this;
    const names = ['error', 'fx', 'fy', 'flags'];
    const [error, fx, fy, flags] = await Promise.all(names.map((name) => recording.fetchColumn(recording.tracks.link, chunk, name)));
    for (let f = 0; thing.index < chunk.slots && f < chunk.frames; f++) {
      const i = f * chunk.slots + thing.index;
      if (flags[i] & There) {
        values.error[chunk.first + f] = Math.abs(error[i]);
        values.force[chunk.first + f] = Math.hypot(fx[i], fy[i]);
      }
    }
  }
}
