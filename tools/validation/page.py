"""Tables and figures of docs/validation.md, between their marks, and runs of the program kept in a folder so that none is made twice."""
import html
import json
import math
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/validation.md"
FIGURES = ROOT / "docs/figures"
COLOURS = ["#1f5fa8", "#c4502a", "#2f8f4e", "#7b4fa3", "#8a6d1a", "#444444"]


def spread(values, digits):
    """Mean and, of several, their deviation: "46.1 +- 0.3"."""
    mean = f"{statistics.mean(values):.{digits}f}"
    return mean if len(values) == 1 else f"{mean} +- {statistics.stdev(values):.{digits}f}"


def table(head, rows):
    """A table in Markdown."""
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in [head, ["---"] * len(head), *rows])


def write(topic, text, page=PAGE):
    """Puts the text between the topic's marks in a page (docs/validation.md); the marks stand where the page's writer has put them."""
    begin, end = f"<!-- {topic}: made by make validate -->", f"<!-- {topic}: end -->"
    whole = page.read_text()
    if begin not in whole or end not in whole:
        raise SystemExit(f"{page.relative_to(ROOT)}: no marks '{begin}' and '{end}'")
    page.write_text(whole[:whole.index(begin)] + begin + "\n" + text + "\n" + whole[whole.index(end):])
    print(f"{topic}: written to {page.relative_to(ROOT)}")


def records(command, kept, dry=False):
    """What a validation program prints, one JSON object a line; its output is kept in the file `kept` and not made twice."""
    if not kept.exists():
        if dry:
            return []
        print(" ".join(str(word) for word in command), flush=True)
        kept.parent.mkdir(parents=True, exist_ok=True)
        aside = kept.with_suffix(".part")
        with open(aside, "w") as out:
            subprocess.run([str(word) for word in command], stdout=out, check=True)
        aside.rename(kept)
    return [json.loads(line) for line in kept.read_text().splitlines() if line.startswith("{")]


class Chart:
    """A line chart as an SVG file of its own: axes linear or logarithmic, curves and points with a legend, in the corner or beside the chart."""

    width, height, left, right, top, bottom = 640, 400, 70, 16, 16, 48

    def __init__(self, x_label, y_label, log_x=False, log_y=False, legend_beside=False):
        self.x_label, self.y_label, self.log_x, self.log_y = x_label, y_label, log_x, log_y
        self.curves = []
        self.legend = self.width - 190
        if legend_beside:
            self.width, self.right, self.legend = 900, 276, 636

    def add(self, label, xs, ys, points=False, dashed=False):
        """A curve (or points) with its word in the legend."""
        pairs = [(x, y) for x, y in zip(xs, ys) if not (self.log_x and x <= 0) and not (self.log_y and y <= 0)]
        self.curves.append((label, pairs, points, dashed))

    def save(self, name):
        """Writes docs/figures/<name>.svg; returns the Markdown that shows it."""
        FIGURES.mkdir(parents=True, exist_ok=True)
        (FIGURES / f"{name}.svg").write_text(self.svg())
        return f"![{self.y_label} over {self.x_label}](figures/{name}.svg)"

    def svg(self):
        across = Axis([x for _, pairs, _, _ in self.curves for x, _ in pairs], self.log_x, self.left, self.width - self.right)
        up = Axis([y for _, pairs, _, _ in self.curves for _, y in pairs], self.log_y, self.height - self.bottom, self.top)
        parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" font-family="sans-serif" font-size="12">',
                 '<rect width="100%" height="100%" fill="white"/>']
        for tick in across.ticks():
            x = across(tick)
            parts.append(f'<path d="M{x:.1f} {self.top}V{self.height - self.bottom}" stroke="#ddd"/>'
                         f'<text x="{x:.1f}" y="{self.height - self.bottom + 16}" text-anchor="middle">{tick:g}</text>')
        for tick in up.ticks():
            y = up(tick)
            parts.append(f'<path d="M{self.left} {y:.1f}H{self.width - self.right}" stroke="#ddd"/>'
                         f'<text x="{self.left - 6}" y="{y + 4:.1f}" text-anchor="end">{tick:g}</text>')
        parts.append(f'<text x="{(self.left + self.width) / 2:.0f}" y="{self.height - 10}" text-anchor="middle">{html.escape(self.x_label)}</text>'
                     f'<text transform="translate(16 {self.height / 2:.0f}) rotate(-90)" text-anchor="middle">{html.escape(self.y_label)}</text>')
        for k, (label, pairs, points, dashed) in enumerate(self.curves):
            colour = COLOURS[k % len(COLOURS)]
            places = [(across(x), up(y)) for x, y in pairs]
            if points:
                parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places]
            else:
                path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
                dash = ' stroke-dasharray="6 4"' if dashed else ""
                parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.6"{dash}/>')
            y = self.top + 16 + 16 * k
            dash = ' stroke-dasharray="6 4"' if dashed else ""
            parts.append(f'<path d="M{self.legend} {y - 4}h20" stroke="{colour}" stroke-width="2"{dash}/>'
                         f'<text x="{self.legend + 26}" y="{y}">{html.escape(label)}</text>')
        return "\n".join([*parts, "</svg>", ""])


class Axis:
    """Numbers to places on the paper."""

    def __init__(self, values, log, start, end):
        self.log, self.start, self.end = log, start, end
        low, high = min(values), max(values)
        if log:
            self.low, self.high = math.floor(math.log10(low)), math.ceil(math.log10(high))
        else:
            margin = 0.04 * (high - low or 1)
            self.low, self.high = (low if low == 0 else low - margin), high + margin
        if self.low == self.high:
            self.high += 1

    def __call__(self, value):
        value = math.log10(value) if self.log else value
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self):
        if self.log:
            return [10.0**k for k in range(self.low, self.high + 1)]
        step = 10 ** math.floor(math.log10((self.high - self.low) / 4))
        step *= next(f for f in (1, 2, 5, 10) if (self.high - self.low) / (step * f) <= 6)
        return [round(k * step, 12) for k in range(math.ceil(self.low / step), math.floor(self.high / step) + 1)]
