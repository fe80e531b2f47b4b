using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>A geom's material and filters, and the collider that mirrors them while the geom is in a world.</summary>
internal sealed class GeomLink
{
    private readonly Geom _geom;
    private World? _world;

    public GeomLink(Geom geom) => _geom = geom;

    public float Friction { get; private set; }

    public float Restitution { get; private set; }

    public int Group { get; private set; }

    public CollisionCategory Categories { get; private set; } = CollisionCategory.All;

    public CollisionCategory CollidesWith { get; private set; } = CollisionCategory.All;

    public bool CollisionEnabled { get; private set; } = true;

    public bool ResponseEnabled { get; private set; } = true;

    public bool IsSensor { get; private set; }

    public Handle Handle { get; private set; }

    /// <summary>The body whose slot the collider is on; differs from the geom's body between <c>SetBody</c> and the next update.</summary>
    public Body? AttachedBody { get; private set; }

    public bool IsAttached => _world is not null;

    public void CopyFrom(GeomLink other)
    {
        Friction = other.Friction;
        Restitution = other.Restitution;
        Group = other.Group;
        Categories = other.Categories;
        CollidesWith = other.CollidesWith;
        CollisionEnabled = other.CollisionEnabled;
        ResponseEnabled = other.ResponseEnabled;
        IsSensor = other.IsSensor;
    }

    public void SetMaterial(float friction, float restitution)
    {
        Friction = friction;
        Restitution = restitution;
        if (_world is not null)
        {
            ref ColliderInfo info = ref _world.Collider(Handle);
            info.Friction = friction;
            info.Restitution = restitution;
            _world.NoteChanged(Handle);
        }
    }

    public void SetFilter(int group, CollisionCategory categories, CollisionCategory collidesWith)
    {
        Group = group;
        Categories = categories;
        CollidesWith = collidesWith;
        PushFilter();
    }

    public void SetCollisionEnabled(bool value)
    {
        CollisionEnabled = value;
        PushFilter();
    }

    public void SetResponse(bool responseEnabled, bool isSensor)
    {
        ResponseEnabled = responseEnabled;
        IsSensor = isSensor;
        PushFlags();
    }

    /// <summary>Tells the world which events are wanted, so that a pair without handlers costs nothing.</summary>
    public void PushFlags()
    {
        if (_world is not null)
        {
            _world.Collider(Handle).Flags = Flags();
            _world.NoteChanged(Handle);
        }
    }

    public void Attach(World world)
    {
        Handle = world.CreateCollider(_geom.Body.Link.Handle, _geom.Form!.Shape, new ColliderDef
        {
            Flags = Flags(),
            Friction = Friction,
            Restitution = Restitution,
            Group = Group,
            Categories = (uint)Categories,
            CollidesWith = (uint)CollidesWith,
            Offset = _geom.EffectiveOffset,
            RotationOffset = _geom.RotationOffset,
        });
        world.Collider(Handle).Order = _geom.Id;
        AttachedBody = _geom.Body;
        _world = world;
    }

    public void Detach()
    {
        World world = _world!;
        _world = null;
        AttachedBody = null;
        world.DestroyCollider(Handle);
        Handle = default;
    }

    private ColliderFlags Flags()
    {
        ColliderFlags flags = ColliderFlags.Alive;
        flags |= CollisionEnabled ? ColliderFlags.CollisionEnabled : ColliderFlags.None;
        flags |= ResponseEnabled && !IsSensor ? ColliderFlags.ResponseEnabled : ColliderFlags.None;
        flags |= _geom.OnCollision is not null ? ColliderFlags.WantsContact : ColliderFlags.None;
        flags |= _geom.OnSeparation is not null ? ColliderFlags.WantsSeparation : ColliderFlags.None;
        return flags;
    }

    private void PushFilter()
    {
        if (_world is null)
        {
            return;
        }

        ref ColliderInfo info = ref _world.Collider(Handle);
        info.Group = Group;
        info.Categories = (uint)Categories;
        info.CollidesWith = (uint)CollidesWith;
        info.Flags = Flags();
        _world.Refilter(Handle);
    }
}
