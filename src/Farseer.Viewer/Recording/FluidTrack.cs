using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>The outlines of waves, and of fluids in a box.</summary>
internal sealed class FluidTrack
{
    private const int X = 0;
    private const int Y = 1;

    private readonly References<Controller> _fluids = new References<Controller>();
    private readonly List<int> _starts = new List<int>();
    private int _points;

    public Track Track { get; } = new Track(
        "fluid",
        new ColumnSpec("x", ColumnKind.Single, Digits.Place),
        new ColumnSpec("y", ColumnKind.Single, Digits.Place));

    /// <summary>How many points each outline has.</summary>
    public List<int> Counts { get; } = new List<int>();

    public void Record(ControllerList controllers)
    {
        Track.Begin(_points);
        for (int i = 0; i < controllers.Count; i++)
        {
            if (controllers[i] is WaveController { CurrentWave: { } heights, XPosition: { } places } wave)
            {
                int at = Take(wave, heights.Length + 2);
                for (int k = 0; at >= 0 && k < heights.Length; k++)
                {
                    Put(at++, places[k], wave.Position.Y + heights[k]);
                }

                if (at >= 0)
                {
                    Put(at++, wave.Position.X + wave.Width, wave.Position.Y + wave.Height);
                    Put(at, wave.Position.X, wave.Position.Y + wave.Height);
                }
            }
            else if (controllers[i] is FluidDragController { Container: AABBFluidContainer { AABB: { } box } })
            {
                int at = Take(controllers[i], 4);
                Put(at, box.Min.X, box.Min.Y);
                Put(at + 1, box.Max.X, box.Min.Y);
                Put(at + 2, box.Max.X, box.Max.Y);
                Put(at + 3, box.Min.X, box.Max.Y);
            }
        }
    }

    /// <summary>Where the points of an outline begin; -1 of one that has another number of points by now.</summary>
    private int Take(Controller controller, int points)
    {
        int fluid = _fluids.Number(controller, out bool isNew);
        if (isNew)
        {
            _starts.Add(_points);
            Counts.Add(points);
            _points += points;
            Track.Grow(_points);
        }

        return Counts[fluid] == points ? _starts[fluid] : -1;
    }

    private void Put(int at, float x, float y)
    {
        Track.Set(at, X, x);
        Track.Set(at, Y, y);
    }
}
