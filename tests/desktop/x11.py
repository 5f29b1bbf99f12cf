"""What no tool on the command line does: a file dropped onto a window, and the pixels that are on the screen."""

import ctypes
import struct

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
SUBSTRUCTURE = 0x180000  # who listens to that is the window manager
REPLACE, ALL_PLANES, Z_PIXMAP = 0, -1, 2


class Image(ctypes.Structure):
    """Xlib's XImage, as far as it is read here."""
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int), ("unit", ctypes.c_int), ("bit_order", ctypes.c_int),
                ("pad", ctypes.c_int), ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int)]


class Display:
    """A connection of our own to the display."""

    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        for name in ("XOpenDisplay", "XDefaultRootWindow", "XCreateSimpleWindow", "XInternAtom"):
            getattr(self.x, name).restype = ctypes.c_void_p
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))

    def close(self):
        self.x.XCloseDisplay(self.display)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def pixels(self, window, width, height):
        """Rows of a window's pixels, four bytes each."""
        image = self.x.XGetImage(self.display, ctypes.c_ulong(window), 0, 0, width, height, ctypes.c_ulong(ALL_PLANES), Z_PIXMAP)
        stride = image.contents.bytes_per_line
        data = ctypes.string_at(image.contents.data, stride * height)
        self.x.XDestroyImage(image)
        return [data[y * stride:y * stride + 4 * width] for y in range(height)]

    def send(self, window, event):
        self.x.XSendEvent(self.display, ctypes.c_ulong(window), 0, ctypes.c_long(0), event.ljust(192, b"\0"))
        self.x.XFlush(self.display)

    def message(self, window, kind, *data):
        data = [*data, 0, 0, 0, 0, 0][:5]
        self.send(window, struct.pack("=i4xqi4xqQQi4x5q", CLIENT_MESSAGE, 0, 1, 0, window, self.atom(kind), 32, *data))

    def set_scale(self, scale):
        """As a desktop's settings do: to be seen by windows that are opened after that."""
        text = f"Xft.dpi:\t{96 * scale:g}\n".encode()
        root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        self.x.XChangeProperty(self.display, root, ctypes.c_ulong(self.atom("RESOURCE_MANAGER")), ctypes.c_ulong(31), 8, REPLACE,
                               text, len(text))
        self.x.XFlush(self.display)

    def has_manager(self):
        kind, form, count, left, data = ctypes.c_ulong(), ctypes.c_int(), ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_void_p()
        self.x.XGetWindowProperty(self.display, ctypes.c_ulong(self.x.XDefaultRootWindow(self.display)),
                                  ctypes.c_ulong(self.atom("_NET_SUPPORTED")), ctypes.c_long(0), ctypes.c_long(1), 0, ctypes.c_ulong(0),
                                  *map(ctypes.byref, (kind, form, count, left, data)))
        return count.value > 0

    def maximise(self, window, on):
        """Asks the window manager, as a window's title bar does."""
        states = (self.atom(f"_NET_WM_STATE_MAXIMIZED_{way}") for way in ("VERT", "HORZ"))
        event = struct.pack("=i4xqi4xqQQi4x5q", CLIENT_MESSAGE, 0, 1, 0, window, self.atom("_NET_WM_STATE"), 32, on, *states, 1, 0)
        root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        self.x.XSendEvent(self.display, root, 0, ctypes.c_long(SUBSTRUCTURE), event.ljust(192, b"\0"))
        self.x.XFlush(self.display)

    def next_event(self, kind):
        event = ctypes.create_string_buffer(192)
        while True:
            self.x.XNextEvent(self.display, event)
            if struct.unpack_from("=i", event)[0] == kind:
                return event.raw

    def drop(self, window, file):
        """As if a file manager's file were let go over the window (the XDND protocol)."""
        source = self.x.XCreateSimpleWindow(self.display, ctypes.c_void_p(self.x.XDefaultRootWindow(self.display)),
                                            0, 0, 1, 1, 0, ctypes.c_ulong(0), ctypes.c_ulong(0))
        selection, uris, copy = (self.atom(name) for name in ("XdndSelection", "text/uri-list", "XdndActionCopy"))
        self.x.XSetSelectionOwner(self.display, ctypes.c_ulong(selection), ctypes.c_ulong(source), ctypes.c_ulong(0))
        self.message(window, "XdndEnter", source, 5 << 24, uris)
        self.message(window, "XdndPosition", source, 0, 10 << 16 | 10, 0, copy)
        self.next_event(CLIENT_MESSAGE)  # it would take it
        self.message(window, "XdndDrop", source)
        event = self.next_event(SELECTION_REQUEST)
        requestor, _, target, where, when = struct.unpack_from("=5Q", event, 40)
        text = f"{file.as_uri()}\r\n".encode()
        self.x.XChangeProperty(self.display, ctypes.c_ulong(requestor), ctypes.c_ulong(where), ctypes.c_ulong(target), 8, REPLACE,
                               text, len(text))
        self.send(requestor, struct.pack("=i4xqi4xq5Q", SELECTION_NOTIFY, 0, 1, 0, requestor, selection, target, where, when))
        self.next_event(CLIENT_MESSAGE)  # it has it
