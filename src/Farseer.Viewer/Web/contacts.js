// ---- contacts: where, which way, and how strong ----

const MostLines = 2500;

// Contacts are kept in the coordinates of the body of their first geom, or of the second if the first is static.
function drawContacts(painter, row) {
  const { context, camera, width, height, recording } = painter;
  const bodies = painter.rowsNow.body;
  const { body: bodyOf } = recording.geoms;
  const end = row.at + row.slots;
  let strongest = 0;
  for (let i = row.at; i < end; i++) {
    if (row.there[i]) {
      strongest = Math.max(strongest, row.push[i]);
    }
  }

  const longest = 46;
  const reach = camera.scale * painter.smallestReach();
  const dot = reach < 6 ? 0 : reach < 12 ? 1 : 2;
  context.lineWidth = dot < 2 ? 0.75 : 1.25;
  context.strokeStyle = palette.contact;
  context.fillStyle = palette.contact;
  const lines = [];
  const lengths = [];
  for (let i = row.at; i < end; i++) {
    if (!row.there[i]) {
      continue;
    }

    const first = bodies.at + bodyOf[row.a[i]];
    const at = bodies.flags[first] & Static ? bodies.at + bodyOf[row.b[i]] : first;
    const cos = Math.cos(bodies.angle[at]);
    const sin = Math.sin(bodies.angle[at]);
    const px = width / 2 + (bodies.x[at] - camera.x + cos * row.x[i] - sin * row.y[i]) * camera.scale;
    const py = height / 2 + (bodies.y[at] - camera.y + sin * row.x[i] + cos * row.y[i]) * camera.scale * camera.up;
    if (px < -longest || py < -longest || px > width + longest || py > height + longest) {
      continue;
    }

    if (dot > 0) {
      // On whole pixels, which browsers fill fastest.
      context.fillRect(Math.round(px) - dot, Math.round(py) - dot, 2 * dot, 2 * dot);
    }

    const length = strongest > 0 ? Math.sqrt(row.push[i] / strongest) * longest : 0;
    if (length > 2) {
      lengths.push(length);
      lines.push(px, py, px + (cos * row.nx[i] - sin * row.ny[i]) * length, py + (sin * row.nx[i] + cos * row.ny[i]) * length * camera.up);
    }
  }

  drawLines(context, lines, lengths);
}

// Of very many the longest: the others would be under them.
function drawLines(context, lines, lengths) {
  const least = lengths.length > MostLines ? Float64Array.from(lengths).sort()[lengths.length - MostLines] : 0;
  context.beginPath();
  for (let i = 0, traced = 0; i < lengths.length; i++) {
    if (lengths[i] >= least) {
      context.moveTo(lines[4 * i], lines[4 * i + 1]);
      context.lineTo(lines[4 * i + 2], lines[4 * i + 3]);
      if (++traced % BatchSize === 0) {
        context.stroke();
        context.beginPath();
      }
    }
  }

  context.stroke();
}
