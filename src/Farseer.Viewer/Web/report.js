// ---- report: what each update says of its own error ----

const Figures = [
  ['Errors', [['error', 'error'], ['constraintError', 'of the state'], ['motionError', 'of the motion'], ['errorShare', 'as a share'],
    ['budgetLoad', 'of the budget']]],
  ['Contacts', [['contacts', 'contacts'], ['largestPenetration', 'deepest overlap'], ['rmsPenetration', 'rms overlap'],
    ['residualContactSpeed', 'fastest approach'], ['largestSlip', 'slip'], ['largestCreep', 'creep'],
      ['largestImpactError', 'of an impact']]],
  ['Joints', [['joints', 'joints'], ['largestSeparation', 'farthest apart'], ['rmsSeparation', 'rms apart'],
    ['largestTurn', 'turned off, rad'],
    ['residualJointSpeed', 'speed apart']]],
  ['Energy and momentum', [['kineticEnergy', 'kinetic energy'], ['kineticEnergyChange', 'its change'], ['gravityWork', 'work of gravity'],
    ['contactWork', 'of contacts'], ['jointWork', 'of joints'], ['energyError', 'energy error'], ['impactEnergyError', 'of an impact'],
    ['momentumError', 'momentum error']]],
  ['Work', [['iterations', 'iterations'], ['mostIterations', 'most of an island'], ['bodies', 'bodies'], ['asleep', 'asleep']]],
];

// In the order of the enum ErrorCause.
const Causes = ['none', 'an overlap', 'a joint apart', 'slip', 'an impact', 'momentum', 'motion', 'a lost body'];

class Report {
  constructor(panel, app) {
    this.panel = panel;
    this.app = app;
    this.chosen = 'error';
  }

  build() {
    const { app, panel } = this;
    this.cells = new Map();
    this.plot = new Plot('Error', (frame) => app.seek(frame));
    this.worst = make('p');
    const parts = [make('h2', { text: 'Accuracy of the update' }), this.worst, this.plot.element];
    if (!app.recordings.some((recording) => recording.steps.reported.some((flag) => flag > 0))) {
      parts.push(make('p', { class: 'hint', text: 'The run was recorded without reports.' }));
    }

    this.buttons = new Map();
    for (const [title, figures] of Figures) {
      const rows = figures.map(([name, label]) => {
        const cells = app.recordings.map(() => make('td', { 'data-key': name }));
        this.cells.set(name, cells);
        const button = make('button', { text: label, 'aria-pressed': 'false', title: 'Plot it', onclick: () => this.choose(name, label) });
        this.buttons.set(name, button);
        return make('tr', {}, make('th', { scope: 'row' }, button), ...cells);
      });
      parts.push(make('h3', { text: title }), make('table', { class: 'values' }, make('tbody', {}, ...rows)));
    }

    panel.replaceChildren(...parts);
    this.choose('error', 'Error');
  }

  choose(name, label) {
    this.chosen = name;
    this.buttons.forEach((button, key) => button.setAttribute('aria-pressed', String(key === name)));
    this.plot.title = label;
    this.plot.element.querySelector('span').textContent = label[0].toUpperCase() + label.slice(1);
    this.plot.show(this.app.recordings.map((recording) => recording.steps[name]), this.app.frames);
    this.plot.draw(this.app.frame);
  }

  update() {
    const { app } = this;
    this.cells.forEach((cells, name) => cells.forEach((cell, i) => {
      const recording = app.recordings[i];
      cell.textContent = shortText(recording.steps[name][recording.clamp(app.frame)]);
    }));
    this.plot.draw(app.frame);
    this.showWorst();
  }

  showWorst() {
    const { app } = this;
    const recording = app.recordings[0];
    const { steps } = recording;
    const frame = recording.clamp(app.frame);
    const parts = [`Largest: ${Causes[steps.cause[frame]] ?? 'unknown'}`];
    const add = (thing, before) => thing.index >= 0 && parts.push(before, make('button', {
      class: 'link', text: recording.nameOf(thing), onclick: () => { app.pick(thing); app.openTab('inspect'); },
    }));
    add({ type: 'link', index: steps.worstJoint[frame] }, ', ');
    add({ type: 'body', index: steps.worstBody[frame] }, ', ');
    add({ type: 'body', index: steps.worstPartner[frame] }, ' and ');
    this.worst.replaceChildren(...parts);
  }
}
