using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>Bodies that gravity pulls otherwise than the rest, and those on rails.</content>
public partial class PhysicsSimulator
{
    private readonly List<Body> _scaled = new List<Body>();
    private readonly List<Body> _railed = new List<Body>();

    /// <summary>A body came, or its gravity changed.</summary>
    internal void NoteGravity(Body body)
    {
        if (!body.IsGravityNoted && body.GravityScale != 1)
        {
            body.IsGravityNoted = true;
            _scaled.Add(body);
        }
    }

    /// <summary>The rails of a body are to be laid anew at the next update.</summary>
    internal void NoteRails(Body body)
    {
        if (!body.IsRailNoted)
        {
            body.IsRailNoted = true;
            _railed.Add(body);
        }
    }

    /// <summary>Pulls at bodies as much as their gravity says: the engine leaves gravity out for them.</summary>
    private void PullScaled()
    {
        int kept = 0;
        for (int i = 0; i < _scaled.Count; i++)
        {
            Body body = _scaled[i];
            if (!ReferenceEquals(body.Simulator, this) || body.Link.World is null || body.GravityScale == 1)
            {
                body.IsGravityNoted = false;
                continue;
            }

            _scaled[kept++] = body;
            if (!body.IgnoreGravity && body.Awake && body.Link.IsSimulated)
            {
                body.Link.ForceRef.Force += body.Mass * body.GravityScale * Gravity;
            }
        }

        _scaled.RemoveRange(kept, _scaled.Count - kept);
    }

    /// <summary>Lays the rails of bodies that were locked, let go or moved.</summary>
    private void LayRails()
    {
        for (int i = 0; i < _railed.Count; i++)
        {
            Body body = _railed[i];
            body.IsRailNoted = false;
            if (ReferenceEquals(body.Simulator, this) && body.Link.World is not null)
            {
                RailLink.Lay(World, body);
            }
        }

        _railed.Clear();
    }
}
