// ---- camera: what part of the world is seen, the same for all stages ----

class Camera {
  constructor(yUp) {
    this.x = 0;
    this.y = 0;
    this.scale = 1;
    this.up = yUp ? -1 : 1;
  }

  // Pixels of the canvas for a point of the world.
  toScreen(x, y, width, height) {
    return [width / 2 + (x - this.x) * this.scale, height / 2 + (y - this.y) * this.scale * this.up];
  }

  toWorld(px, py, width, height) {
    return [this.x + (px - width / 2) / this.scale, this.y + (py - height / 2) / (this.scale * this.up)];
  }

  fit([minX, minY, maxX, maxY], width, height) {
    const margin = 0.96;
    this.x = (minX + maxX) / 2;
    this.y = (minY + maxY) / 2;
    this.scale = margin * Math.min(width / Math.max(maxX - minX, 1e-30), height / Math.max(maxY - minY, 1e-30));
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y -= dy / (this.scale * this.up);
  }

  // Zooms so that the point under the pointer stays.
  zoom(factor, px, py, width, height) {
    const [x, y] = this.toWorld(px, py, width, height);
    this.scale = Math.max(1e-12, Math.min(1e12, this.scale * factor));
    const [nowX, nowY] = this.toWorld(px, py, width, height);
    this.x += x - nowX;
    this.y += y - nowY;
  }
}
