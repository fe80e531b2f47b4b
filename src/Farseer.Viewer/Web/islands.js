// ---- islands: bodies that hang together by contacts, joints and springs, found from what is recorded ----

class Islands {
  constructor(recording) {
    this.recording = recording;
    this.roots = new Int32Array(recording.meta.bodyCount);
    this.frame = -1;
  }

  // The lowest body of the island of each body; -1 of what does not move.
  find(frame, bodies, contacts, links) {
    if (frame === this.frame) {
      return this.roots;
    }

    this.frame = frame;
    const { roots, recording } = this;
    roots.fill(-1);
    for (let body = 0; body < bodies.slots; body++) {
      const flags = bodies.flags[bodies.at + body];
      if ((flags & There) && !(flags & (Static | Kinematic))) {
        roots[body] = body;
      }
    }

    const { body: bodyOf, sensor } = recording.geoms;
    for (let i = contacts.at; i < contacts.at + contacts.slots; i++) {
      if (contacts.there[i] && !sensor[contacts.a[i]] && !sensor[contacts.b[i]]) {
        this.join(bodyOf[contacts.a[i]], bodyOf[contacts.b[i]]);
      }
    }

    recording.meta.links.forEach(({ a, b }, i) => {
      if (a >= 0 && b >= 0 && i < links.slots && (links.flags[links.at + i] & LinkEnabled)) {
        this.join(a, b);
      }
    });

    for (let body = 0; body < roots.length; body++) {
      if (roots[body] >= 0) {
        roots[body] = this.rootOf(body);
      }
    }

    return roots;
  }

  rootOf(body) {
    const { roots } = this;
    while (roots[body] !== body) {
      roots[body] = roots[roots[body]];
      body = roots[body];
    }

    return body;
  }

  join(a, b) {
    if (this.roots[a] < 0 || this.roots[b] < 0) {
      return;
    }

    const one = this.rootOf(a);
    const two = this.rootOf(b);
    this.roots[Math.max(one, two)] = Math.min(one, two);
  }
}
