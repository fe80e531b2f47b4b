using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Queries;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Springs;

namespace Farseer.Engine.Simulation;

/// <summary>A phase of a step: the stores that it shares with the others.</summary>
internal abstract class WorldPhase
{
    protected readonly WorldStores _stores;
    protected readonly BodyStore _bodies;
    protected readonly ShapeStore _shapes;
    protected readonly ColliderLists _colliders;
    protected readonly ProxyStore _proxies;
    protected readonly ContactStore _contacts;
    protected readonly ConstraintGraph _graph;
    protected readonly IslandStore _islands;
    protected readonly JointStore _joints;
    protected readonly SpringStore _springs;
    protected readonly BodyLists _lists;
    protected readonly WorldSettings _settings;
    protected readonly WorldQueries _queries;

    protected WorldPhase(WorldStores stores)
    {
        _stores = stores;
        _bodies = stores.Bodies;
        _shapes = stores.Shapes;
        _colliders = stores.Colliders;
        _proxies = stores.Proxies;
        _contacts = stores.Contacts;
        _graph = stores.Graph;
        _islands = stores.Islands;
        _joints = stores.Joints;
        _springs = stores.Springs;
        _lists = stores.Lists;
        _settings = stores.Settings;
        _queries = stores.Queries;
    }
}
