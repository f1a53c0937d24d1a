"""Parts of tools/reproduce."""
