"""Parts of tools/campaign: plan (what to run), folder (what there is of it), runner (running it)."""
