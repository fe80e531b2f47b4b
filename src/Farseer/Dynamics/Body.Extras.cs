using System;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>What a body keeps that nearly none has.</content>
public partial class Body
{
    /// <summary>What nearly no body has.</summary>
    private sealed class BodyExtras
    {
        public const float UsualMinimumVelocity = 55;

        public EventHandler<EventArgs>? Disposed;
        public UpdatedEventHandler? Updated;
        [NotState(Why.Users)]
        public object? Tag;
        [NotState(Why.Users)]
        public string? Name;
        public float IdleTime;
        public float MinimumVelocity = UsualMinimumVelocity;
        public float GravityScale = 1;
        public MotionLocks Locks;

        /// <summary>The moment of inertia while the body may not turn; 0: it may.</summary>
        public float FixedInertia;

        // What the handlers of moves heard last.
        public double ToldX;
        public double ToldY;
        public double ToldAngle;

        /// <summary>But for what is the user's own it is as if there were none.</summary>
        public bool IsUsual => Disposed is null && Updated is null && IsUsualButForUsers;

        /// <summary>The same but for handlers, which no other world gets.</summary>
        public bool IsUsualButForUsers =>
            IdleTime == 0 && MinimumVelocity == UsualMinimumVelocity
            && GravityScale == 1 && Locks == MotionLocks.None && FixedInertia == 0 && ToldX == 0 && ToldY == 0 && ToldAngle == 0;
    }
}
