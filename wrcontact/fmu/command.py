"""What the command ``wrcontact build`` packs."""

from ..kernel.binding.files import PLATFORMS


def built(native, platforms, side=None, **chosen):
    """Build the FMUs and return their paths; ``platforms`` is "all", names with commas, or None, ``side``
    that of one wheel by itself or None, ``chosen`` the arguments of :func:`~wrcontact.fmu.build_fmu`."""
    from .build import build_fmu
    from .native import build_native_fmus

    if not native:
        return [build_fmu(**chosen)]
    names = list(PLATFORMS) if platforms == "all" else platforms and platforms.split(",")
    one = {"side": side} if side else {}
    return build_native_fmus(**chosen, **one, platforms=names)
