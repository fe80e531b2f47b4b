using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Bodies that have lost mass since the last step. The impulses that their contacts start from were found with the mass before: from the
/// ground they throw the body up, and before its contact with the ground takes that back, those with what lies on it have been thrown as
/// well. A box on a plate that went from 1 kg to 10 g left at 0.45 m/s, sixty on one that went from 100 kg to 10 g at 90.
/// </summary>
internal sealed unsafe class LightenedBodies
{
    private readonly IndexList _bodies = new IndexList();

    /// <summary>Of the mass before, by body; 0: all of it.</summary>
    private readonly Column<float> _share = new Column<float>();

    /// <param name="body">The body.</param>
    /// <param name="share">What it has of the mass, or of the moment of inertia, that it had.</param>
    public void Note(int body, float share)
    {
        _share.EnsureCapacity(body + 1);
        if (_share[body] == 0)
        {
            _bodies.Add(body);
            _share[body] = 1;
        }

        _share[body] *= share;
    }

    /// <summary>Contacts of these bodies start from as much less.</summary>
    public void ScaleImpulses(ConstraintGraph graph, int bodyEnd)
    {
        if (_bodies.Count == 0)
        {
            return;
        }

        _share.EnsureCapacity(bodyEnd);
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    float share = Math.Min(ShareOf(row->BodyA[lane]), ShareOf(row->BodyB[lane]));
                    if (share < 1)
                    {
                        ContactLanes.Scale(row, lane, share);
                    }
                }
            }
        }

        for (int i = 0; i < _bodies.Count; i++)
        {
            _share[_bodies[i]] = 0;
        }

        _bodies.Clear();
    }

    private float ShareOf(int body) => _share[body] == 0 ? 1 : _share[body];

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _bodies.Visit(s);
        s.Column(_share);
    }
}
