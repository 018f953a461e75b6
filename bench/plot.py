"""Line plots as SVG, for bench/run: no library has to be there for them."""

import math

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 860, 300, 70, 40, 320, 200
COLORS = ("#2a6fb0", "#c0502a", "#3d8a4a")


def panel(left, title, unit, lines, label, colors):
    """Lines, name -> points (faces, value), over a logarithmic axis of faces.

    The axis of values begins at 0.
    """
    faces = sorted({x for points in lines.values() for x, _ in points})
    low, high = math.log10(faces[0]), math.log10(faces[-1])
    top = 1.15 * max(value for points in lines.values() for _, value in points)

    def place(faces, value):
        along = (math.log10(faces) - low) / (high - low) if high > low else 0.5
        return left + along * PLOT_WIDTH, TOP + PLOT_HEIGHT * (1 - value / top)

    parts = [f'<text x="{left}" y="{TOP - 16}" font-weight="bold">{title}</text>',
             f'<text x="{left}" y="{TOP - 2}" fill="#666">{unit}</text>',
             f'<path d="M{left} {TOP}V{TOP + PLOT_HEIGHT}H{left + PLOT_WIDTH}" '
             'fill="none" stroke="#444"/>']
    for step in range(5):
        value = top * step / 4
        y = place(faces[0], value)[1]
        parts.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{value:.3g}</text>')
        parts.append(f'<path d="M{left} {y:.1f}H{left + PLOT_WIDTH}" stroke="#ddd"/>')
    for x in faces:
        parts.append(f'<text x="{place(x, 0)[0]:.1f}" y="{TOP + PLOT_HEIGHT + 18}" '
                     'text-anchor="middle">'
                     f"{label(x)}</text>")
    for i, ((name, points), color) in enumerate(zip(lines.items(), colors)):
        corners = [place(*point) for point in points]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{color}" stroke-width="2"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{color}"/>' for x, y in corners]
        parts.append(f'<text x="{left + i * PLOT_WIDTH / len(lines):.1f}" '
                     f'y="{TOP + PLOT_HEIGHT + 40}" '
                     f'fill="{color}">{name}</text>')
    return parts


def write(path, panels, label):
    """Two panels side by side, each (title, unit, lines); `label` writes a number of faces.

    Panels that show the same lines show them in the same colours.
    """
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
             f'width="{WIDTH}" '
             f'height="{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    names = list(dict.fromkeys(name for _, _, lines in panels for name in lines))
    for i, (title, unit, lines) in enumerate(panels):
        colors = [COLORS[names.index(name) % len(COLORS)] for name in lines]
        parts += panel(LEFT + i * (LEFT + PLOT_WIDTH + 20), title, unit, lines, label, colors)
    path.write_text("\n".join([*parts, "</svg>"]) + "\n")
