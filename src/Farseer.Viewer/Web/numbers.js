// ---- numbers: how they are shown ----

// The shortest text that gives the same float again.
function singleText(value) {
  if (!Number.isFinite(value)) {
    return String(value);
  }

  for (let digits = 1; digits < 9; digits++) {
    const short = Number(value.toPrecision(digits));
    if (Math.fround(short) === value) {
      return plain(short);
    }
  }

  return plain(Number(value.toPrecision(9)));
}

function plain(value) {
  return String(value);
}

// A number as its column keeps it: all that is kept and not a digit more.
function columnText(column, value) {
  if (Number.isNaN(value)) {
    return 'not a number';
  }

  switch (column.kind) {
    case 'single':
      return singleText(value);
    case 'decimal':
      return value.toFixed(Math.max(0, column.decimals));
    default:
      return plain(value);
  }
}

// A number that was worked out here: four digits.
function shortText(value) {
  if (!Number.isFinite(value)) {
    return '\u2013';
  }

  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    return plain(Number(value.toPrecision(4)).toExponential());
  }

  return plain(Number(value.toPrecision(4)));
}

function countText(count, one, many) {
  return count.toLocaleString('en') + ' ' + (count === 1 ? one : many);
}

// ---- elements ----

function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (name.startsWith('on')) {
      element.addEventListener(name.slice(2), value);
    } else if (name === 'text') {
      element.textContent = value;
    } else if (value !== null && value !== undefined && value !== false) {
      element.setAttribute(name, value === true ? '' : value);
    }
  }

  element.append(...children);
  return element;
}

function byId(id) {
  return document.getElementById(id);
}
