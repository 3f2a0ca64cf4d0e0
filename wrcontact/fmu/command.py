"""What the command ``wrcontact build`` packs."""

from ..kernel.binding.files import PLATFORMS


def built(native, platforms, **chosen):
    """Build the FMUs and return their paths; ``platforms`` is "all", names with commas, or None, ``chosen``
    the arguments of :func:`~wrcontact.fmu.build_fmu`."""
    from .build import build_fmu
    from .native import build_native_fmus

    if not native:
        return [build_fmu(**chosen)]
    names = list(PLATFORMS) if platforms == "all" else platforms and platforms.split(",")
    return build_native_fmus(**chosen, platforms=names)
