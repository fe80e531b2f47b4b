using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>Which geoms there were, from which frame to which, and what they look like in the coordinates of their body.</summary>
internal sealed class GeomTable
{
    private readonly References<Geom> _geoms = new References<Geom>();
    private readonly References<GeomForm> _forms = new References<GeomForm>();

    // By number of the geom: its latest entry. A geom that is given another outline or body gets a new one.
    private readonly List<int> _latest = new List<int>();
    private readonly List<int> _present = new List<int>();

    public List<Entry> Entries { get; } = new List<Entry>();

    public List<GeomForm> Forms { get; } = new List<GeomForm>();

    /// <summary>The latest entry of a geom; -1 of one that was never seen.</summary>
    public int Find(Geom geom)
    {
        int number = _geoms.Find(geom);
        return number < 0 ? -1 : _latest[number];
    }

    public void Record(GeomList geoms, BodyTrack bodies, int frame)
    {
        for (int i = 0; i < geoms.Count; i++)
        {
            Geom geom = geoms[i];
            if (geom.Form is not { } form || geom.Body is not { } body)
            {
                continue;
            }

            int owner = bodies.Find(body);
            if (owner < 0)
            {
                owner = bodies.Take(body);
            }

            int number = _geoms.Number(geom, out bool isNew);
            if (isNew)
            {
                _latest.Add(-1);
            }

            int latest = _latest[number];
            if (latest < 0 || !Entries[latest].Is(form, owner, geom) || Entries[latest].To >= 0)
            {
                _latest[number] = latest = Entries.Count;
                Entries.Add(new Entry(geom, ShapeOf(form), owner, frame));
                _present.Add(latest);
            }

            Entries[latest].Seen = frame;
        }

        _present.RemoveAll(e => IsGone(Entries[e], frame));
    }

    private static bool IsGone(Entry entry, int frame)
    {
        if (entry.Seen == frame)
        {
            return false;
        }

        entry.To = frame;
        return true;
    }

    private int ShapeOf(GeomForm form)
    {
        int shape = _forms.Number(form, out bool isNew);
        if (isNew)
        {
            Forms.Add(form);
        }

        return shape;
    }

    /// <summary>A geom as long as it looks the same.</summary>
    internal sealed class Entry
    {
        private readonly GeomForm _form;

        public Entry(Geom geom, int shape, int body, int from)
        {
            _form = geom.Form!;
            Shape = shape;
            Body = body;
            From = from;
            Offset = geom.Offset;
            Rotation = geom.RotationOffset;
            IsSensor = geom.IsSensor;
            Name = Label.Of(geom.Name, geom.Tag);
        }

        public int Shape { get; }

        public int Body { get; }

        public int From { get; }

        /// <summary>The first frame in which it is no more; -1: it stays to the end.</summary>
        public int To { get; set; } = -1;

        public int Seen { get; set; }

        public Vector2 Offset { get; }

        public float Rotation { get; }

        public bool IsSensor { get; }

        public string? Name { get; }

        public bool Is(GeomForm form, int body, Geom geom) =>
            ReferenceEquals(form, _form) && body == Body && geom.Offset == Offset && geom.RotationOffset == Rotation
                && geom.IsSensor == IsSensor;
    }
}
