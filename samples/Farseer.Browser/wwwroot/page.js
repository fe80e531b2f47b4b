// The library runs in the page's own thread: a frame makes the steps that are due, at most a few, and draws once.
const mostSteps = 4;
const canvas = document.getElementById('canvas');
const figures = document.getElementById('figures');
const choice = document.getElementById('scene');
const pause = document.getElementById('pause');
const kinds = { line: 0, polygon: 1, circle: 2, point: 3 };

const { dotnet } = await import('./_framework/dotnet.js').catch(() => {
  figures.value = 'the library is not published beside this page: dotnet publish -c Release samples/Farseer.Browser';
  throw new Error(figures.value);
});
const runtime = await dotnet.create();
const library = (await runtime.getAssemblyExports(runtime.getConfig().mainAssemblyName)).Farseer.Browser.Program;
let view = null;
let isPaused = false;
let left = 0;
let last = performance.now();
let stepTime = 0;

function start(name) {
  const [minX, minY, maxX, maxY, dt, up] = library.Start(name);
  view = { minX, minY, maxX, maxY, dt, up };
  left = 0;
  stepTime = 0;
}

function step(count) {
  const before = performance.now();
  const steps = library.Step(count);
  stepTime += 0.1 * ((performance.now() - before) / count - stepTime);
  return steps;
}

const css = color => `rgb(${color >>> 24} ${(color >>> 16) & 255} ${(color >>> 8) & 255} / ${(color & 255) / 255})`;

function draw() {
  const density = window.devicePixelRatio;
  canvas.width = canvas.clientWidth * density;
  canvas.height = canvas.clientHeight * density;
  const context = canvas.getContext('2d');
  const scale = Math.min(canvas.width / (view.maxX - view.minX), canvas.height / (view.maxY - view.minY));
  const x = value => (value - (view.minX + view.maxX) / 2) * scale + canvas.width / 2;
  const y = value => ((view.minY + view.maxY) / 2 - value) * view.up * scale + canvas.height / 2;
  context.lineWidth = density;
  const memory = library.Draw();
  const numbers = memory.slice();
  memory.dispose();
  let shapes = 0;
  for (let at = 0; at < numbers.length; shapes++) {
    const [kind, line, fill, count] = numbers.subarray(at, at + 4);
    const values = numbers.subarray(at + 4, at + 4 + count);
    at += 4 + count;
    context.beginPath();
    if (kind === kinds.circle || kind === kinds.point) {
      context.arc(x(values[0]), y(values[1]), kind === kinds.circle ? values[2] * scale : values[2] * density / 2, 0, 2 * Math.PI);
    } else {
      for (let i = 0; i < count; i += 2) {
        context.lineTo(x(values[i]), y(values[i + 1]));
      }
      if (kind === kinds.polygon) {
        context.closePath();
      }
    }
    context.fillStyle = css(fill);
    context.fill();
    context.strokeStyle = css(line);
    context.stroke();
  }
  return shapes;
}

function frame(now) {
  if (!isPaused) {
    left = Math.min(left + (now - last) / 1000, mostSteps * view.dt);
    const due = Math.floor(left / view.dt);
    if (due > 0) {
      left -= due * view.dt;
      const steps = step(due);
      const shapes = draw();
      figures.value = `step ${steps}, ${stepTime.toFixed(2)} ms a step, ${shapes} shapes, hash ${library.StateHash()}`;
    }
  }
  last = now;
  requestAnimationFrame(frame);
}

for (const name of library.Scenes()) {
  choice.add(new Option(name));
}
choice.onchange = () => start(choice.value);
document.getElementById('again').onclick = () => start(choice.value);
pause.onclick = () => {
  isPaused = !isPaused;
  pause.textContent = isPaused ? 'Go on' : 'Pause';
};
start(choice.value);
requestAnimationFrame(frame);

// For tests: a scene's hash after so many steps, in another world than the one that is shown.
window.farseer = {
  hash(name, steps) {
    isPaused = true;
    start(name);
    step(steps);
    return library.Hash();
  },
};
