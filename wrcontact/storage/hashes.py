"""Hashes of contents: what is kept belongs to exactly these."""

from hashlib import sha256


def content_hash(*contents):
    """SHA-256 of texts or bytes, one behind the other, as hexadecimal digits."""
    found = sha256()
    for content in contents:
        found.update(content.encode() if isinstance(content, str) else content)
    return found.hexdigest()
