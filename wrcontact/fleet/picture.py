"""Pictures of many pairs, as files of PNG."""

import io

from matplotlib.backends.backend_agg import FigureCanvasAgg

from ..plots import check_figure
from ..plots.style import styled

#: Compression of a picture: 5 % larger than with matplotlib's 6, at half of that cost.
COMPRESSION = 3

#: Places of the panels and of the title, by their numbers: those of the first picture of its kind.
_layouts = {}


@styled
def picture(report):
    """The picture of ``wrcontact check`` as the bytes of a PNG.

    All pictures of a process have the layout of its first, since matplotlib needs a third of its time for the
    layout.
    """
    figure = check_figure(report)
    kind = len(figure.axes), figure.get_suptitle().count("\n")
    if kind not in _layouts:
        figure.draw_without_rendering()
        _layouts[kind] = [axes.get_position() for axes in figure.axes], figure.texts[0].get_position()
    figure.set_layout_engine("none")
    for axes, place in zip(figure.axes, _layouts[kind][0]):
        axes.set_position(place)
    figure.texts[0].set_position(_layouts[kind][1])
    file = io.BytesIO()
    FigureCanvasAgg(figure).print_png(file, pil_kwargs={"compress_level": COMPRESSION})
    return file.getvalue()
