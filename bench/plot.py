"""A line plot as SVG, for bench/run: no library has to be there for it."""

import math

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 860, 300, 70, 40, 320, 200
COLORS = ("#2a6fb0", "#c0502a", "#3d8a4a")


def panel(offset, title, unit, points, label):
    """Points (faces, value) over a logarithmic axis of faces; the axis of values begins at 0."""
    left = LEFT + offset
    low, high = math.log10(points[0][0]), math.log10(points[-1][0])
    top = 1.15 * max(value for _, value in points)

    def place(faces, value):
        along = (math.log10(faces) - low) / (high - low) if high > low else 0.5
        return left + along * PLOT_WIDTH, TOP + PLOT_HEIGHT * (1 - value / top)

    parts = [f'<text x="{left}" y="{TOP - 16}" font-weight="bold">{title}</text>',
             f'<text x="{left}" y="{TOP - 2}" fill="#666">{unit}</text>',
             f'<path d="M{left} {TOP}V{TOP + PLOT_HEIGHT}H{left + PLOT_WIDTH}" fill="none" stroke="#444"/>']
    for step in range(5):
        value = top * step / 4
        y = place(points[0][0], value)[1]
        parts.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{value:.3g}</text>')
        parts.append(f'<path d="M{left} {y:.1f}H{left + PLOT_WIDTH}" stroke="#ddd"/>')
    for faces, _ in points:
        x = place(faces, 0)[0]
        parts.append(f'<text x="{x:.1f}" y="{TOP + PLOT_HEIGHT + 18}" text-anchor="middle">{label(faces)}</text>')
    corners = [place(*point) for point in points]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
    parts.append(f'<polyline points="{line}" fill="none" stroke="{COLORS[offset > 0]}" stroke-width="2"/>')
    parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{COLORS[offset > 0]}"/>' for x, y in corners]
    return parts


def growth(path, times, memory, label):
    """`times` and `memory`: (faces, nanoseconds a face) and (faces, MiB at the peak)."""
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
             f'height="{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    parts += panel(0, "Time a face", "ns, by faces of the input", times, label)
    parts += panel(LEFT + PLOT_WIDTH + 20, "Peak memory", "MiB, by faces of the input", memory, label)
    path.write_text("\n".join([*parts, "</svg>"]) + "\n")
